#include "scale/scale_table.h"

#include "support/text.h"
#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scale {

namespace {

std::string text(const char *format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string ms(double ns) { return bench::numberText(ns / 1e6); }

}  // namespace

NetworkScaling predictScaling(const MeasuredWorld &measured, const Network &network, const std::vector<unsigned> &workers) {
    constexpr double kMinGain = 0.1, kTurn = 0.05;
    constexpr unsigned kMost = 1024;
    const auto frame = [&](unsigned count) { return predictFrame(measured, {count, network, false, true, 0}); };
    NetworkScaling scaling{network, {}, 0};
    for (const unsigned count : workers) scaling.frameNs.push_back(frame(count));
    // Doubling, so that a step which is no better by chance does not end the search early.
    double before = frame(1), best = before;
    unsigned enough = 1;
    for (unsigned count = 2; count <= kMost; count *= 2) {
        const double now = frame(count);
        best = std::min(best, now);
        if (now > (1 - kTurn) * before) break;
        enough = count;
        before = now;
    }
    if (best <= (1 - kMinGain) * measured.homeFrameNs) scaling.enough = enough;
    return scaling;
}

std::string describe(const MeasuredWorld &measured) {
    std::vector<double> islands, bytes, back, longest;
    for (const Step &step : measured.steps) {
        islands.push_back(static_cast<double>(step.size()));
        double sum = 0, results = 0, most = 0;
        for (const Problem &problem : step) {
            sum += problem.bytes;
            results += problem.resultBytes;
            most = std::max(most, problem.solveNs);
        }
        bytes.push_back(sum);
        back.push_back(results);
        longest.push_back(most);
    }
    return measured.world + ": a frame takes " + ms(measured.homeFrameNs) + " ms at home, " + ms(measured.homeStepNs) + " of them the step; " +
           text("%.0f", typical(islands)) + " islands of " + text("%.0f", typical(bytes)) + " bytes, " + text("%.0f", typical(back)) +
           " back; their solver " + ms(measured.solveNs()) + " ms, the longest " + ms(typical(longest)) + "; home's part of them " +
           ms(measured.awayStepNs) + " ms; link " + text("%.0f", measured.latencyNs / 1e3) + " us, " + text("%.2f", measured.nsPerByte) +
           " ns a byte\n";
}

std::string scalingTable(const std::vector<NetworkScaling> &scalings, const std::vector<unsigned> &workers) {
    std::vector<bench::Table::Column> columns = {{"network", bench::Table::Align::Left}};
    for (const unsigned count : workers) columns.push_back({std::to_string(count)});
    columns.push_back({"enough"});
    bench::Table table(columns);
    for (const NetworkScaling &one : scalings) {
        std::vector<std::string> cells = {one.network.name};
        for (const double frame : one.frameNs) cells.push_back(ms(frame));
        cells.push_back(one.enough == 0 ? "stays" : std::to_string(one.enough));
        table.addRow(cells);
    }
    return table.text();
}

std::string scalingHeader() { return "world,network,workers,home_ms,frame_ms,enough\n"; }

std::string scalingLines(const MeasuredWorld &measured, const std::vector<NetworkScaling> &scalings, const std::vector<unsigned> &workers) {
    std::string lines;
    for (const NetworkScaling &one : scalings)
        for (std::size_t i = 0; i < workers.size(); ++i)
            lines += support::csvField(measured.world) + "," + one.network.name + "," + std::to_string(workers[i]) + "," + ms(measured.homeFrameNs) +
                     "," + ms(one.frameNs[i]) + "," + std::to_string(one.enough) + "\n";
    return lines;
}

bool Validation::isGood() const {
    constexpr double kMaxError = 0.2;
    return std::abs(error()) <= kMaxError;
}

namespace {

constexpr const char *kRow = "%-12s %7s  %-11s %9s %10s %10s %7s %7s %5s\n";

std::string islandsOf(const Cluster &cluster) { return cluster.sendsAll ? "all" : "as they pay"; }

}  // namespace

std::string validationTitles() {
    char line[200];
    std::snprintf(line, sizeof line, kRow, "network", "workers", "islands", "home ms", "predicted", "measured", "error", "sent", "late");
    return line;
}

std::string validationRow(const Validation &row) {
    char line[200];
    std::snprintf(line, sizeof line, kRow, row.cluster.network.name.c_str(), std::to_string(row.cluster.workers).c_str(),
                  islandsOf(row.cluster).c_str(), ms(row.measured.homeNs).c_str(), ms(row.predictedNs).c_str(), ms(row.measured.clusterNs).c_str(),
                  text("%+.0f %%", 100 * row.error()).c_str(), text("%.1f", row.measured.sent).c_str(), std::to_string(row.measured.late).c_str());
    return line;
}

std::string validationHeader() { return "world,network,workers,islands,home_ms,predicted_ms,measured_ms,sent,late\n"; }

std::string validationLine(const MeasuredWorld &measured, const Validation &row) {
    return support::csvField(measured.world) + "," + row.cluster.network.name + "," + std::to_string(row.cluster.workers) + "," +
           islandsOf(row.cluster) + "," + ms(row.measured.homeNs) + "," + ms(row.predictedNs) + "," + ms(row.measured.clusterNs) + "," +
           text("%.1f", row.measured.sent) + "," + std::to_string(row.measured.late) + "\n";
}

}  // namespace scale
