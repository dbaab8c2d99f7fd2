#include "support/text.h"
#include "real_time_samples.h"
#include "report.h"

#include <iomanip>
#include <sstream>

namespace bench {

std::string reportSamples(const std::vector<WorldResult> &results) {
    std::ostringstream out;
    out << std::setprecision(6) << "world,engine,second,real_time_factor\n";
    for (const WorldResult &result : results) {
        for (const EngineResult &engine : result.engines) {
            int second = 0;
            for (double factor : realTimeSamples(engine))
                out << support::csvField(result.world) << ',' << support::csvField(engine.engine.name()) << ',' << ++second
                    << ',' << factor << '\n';
        }
    }
    return out.str();
}

}  // namespace bench
