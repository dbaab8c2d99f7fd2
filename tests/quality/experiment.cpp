#include "experiment.h"

namespace quality {

const std::vector<Experiment> &experiments() {
    static const std::vector<Experiment> all = [] {
        std::vector<Experiment> joined;
        for (const auto &part : {restingExperiments(), masonryExperiments(), slidingExperiments(), jointExperiments(), movingExperiments()})
            joined.insert(joined.end(), part.begin(), part.end());
        return joined;
    }();
    return all;
}

}  // namespace quality
