#include "curve.h"
#include "number_text.h"
#include "report.h"
#include "table.h"

#include <cmath>
#include <cstdio>

namespace bench {

namespace {

std::string exponentText(double exponent) {
    if (!std::isfinite(exponent)) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", exponent);
    return text;
}

std::vector<Table::Column> columns(const Curve &curve) {
    std::vector<Table::Column> columns = {{"N"}};
    for (Part part : Curve::kReported)
        for (std::size_t i = 0; i < curve.points[0].engines.size(); ++i) {
            const std::string &engine = curve.points[0].engines[i].engine;
            columns.push_back({i == 0 ? nameOf(part) + (" ms: " + engine) : engine});
            columns.push_back({"growth"});
        }
    return columns;
}

std::vector<std::string> cells(const Curve &curve, std::size_t point) {
    std::vector<std::string> cells = {std::to_string(curve.points[point].size)};
    for (Part part : Curve::kReported)
        for (std::size_t engine = 0; engine < curve.points[point].engines.size(); ++engine) {
            cells.push_back(millisecondsText(curve.seconds(part, point, engine)));
            cells.push_back(exponentText(curve.growth(part, point, engine)));
        }
    return cells;
}

}  // namespace

std::string reportCurves(const std::vector<WorldResult> &results) {
    std::string text;
    for (const Curve &curve : curvesOf(results)) {
        Table table(columns(curve));
        for (std::size_t point = 0; point < curve.points.size(); ++point) table.addRow(cells(curve, point));
        text += "== " + curve.world + ": time over size ==\n\n" + table.text() + "\n";
    }
    return text;
}

}  // namespace bench
