#include "library_release.h"

#include <filesystem>

#include "library_releases.h"
#include "support/text_file.h"

namespace bench {

namespace {

// In each build of ours, in front of the release: the first line of its log (ode_mt/settings/dxSettings.cpp).
const std::string kMark = ", made of ODE ";

bool isOurText(const std::string &text) { return text.find("dToggleODE_MT") != std::string::npos; }

// Returns "" if the text does not say it.
std::string releaseInText(const std::string &text) {
    const std::size_t at = text.find(kMark);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + kMark.size();
    return text.substr(begin, text.find_first_not_of("0123456789.", begin) - begin);
}

}  // namespace

std::string releaseByName(const std::string &file) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(file, error);
    const std::string name = (error ? std::filesystem::path(file) : real).filename();
    for (const NumberedRelease &known : kNumberedReleases)
        if (name == std::string("libode.so.") + known.number) return known.release;
    return kUnknownRelease;
}

std::string releaseOfLibrary(const std::string &file) {
    const std::string text = support::readWhatIsThere(file);
    const std::string said = isOurText(text) ? releaseInText(text) : "";
    return said.empty() ? releaseByName(file) : said;
}

bool isOurLibrary(const std::string &file) { return isOurText(support::readWhatIsThere(file)); }

bool areOtherReleases(const std::string &one, const std::string &other) {
    return one != kUnknownRelease && other != kUnknownRelease && one != other;
}

}  // namespace bench
