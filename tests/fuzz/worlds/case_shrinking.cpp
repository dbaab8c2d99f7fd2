#include "worlds/case_shrinking.h"

#include "worlds/xml_tree.h"

#include <chrono>

namespace fuzz_worlds {

namespace {

using Clock = std::chrono::steady_clock;

class Shrinking {
public:
    Shrinking(WorldCase world, const std::function<bool(const WorldCase &)> &isInteresting, double seconds)
        : m_world(std::move(world)),
          m_isInteresting(isInteresting),
          m_end(Clock::now() +
                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

    WorldCase run() {
        for (bool hasChanged = true; hasChanged && isInTime();) {
            hasChanged = simplifyOptions();
            for (const std::string &file : namesOfFiles()) {
                if (file != kWorldFile && dropFile(file)) {
                    hasChanged = true;
                    continue;
                }
                const bool isTree = parseXml(m_world.files.at(file)) != nullptr;
                hasChanged =
                    (isTree ? dropElements(file) || simplifyElements(file) : dropBytes(file)) || hasChanged;
            }
        }
        return m_world;
    }

private:
    bool isInTime() const { return Clock::now() < m_end; }

    std::vector<std::string> namesOfFiles() const {
        std::vector<std::string> names;
        for (const auto &file : m_world.files) names.push_back(file.first);
        return names;
    }

    bool take(const WorldCase &tried) {
        if (!isInTime() || !m_isInteresting(tried)) return false;
        m_world = tried;
        return true;
    }

    bool takeText(const std::string &file, const std::string &text) {
        if (text == m_world.files.at(file)) return false;
        WorldCase tried = m_world;
        tried.files[file] = text;
        return take(tried);
    }

    bool simplifyOptions() {
        WorldCase tried = m_world;
        tried.ignoreUnsupported = tried.staticMeetsStatic = false;
        tried.staticShapes = 0;
        const bool isSimple =
            !m_world.ignoreUnsupported && !m_world.staticMeetsStatic && m_world.staticShapes == 0;
        return !isSimple && take(tried);
    }

    bool dropFile(const std::string &file) {
        WorldCase tried = m_world;
        tried.files.erase(file);
        return take(tried);
    }

    // Outer elements first, from the back: what comes last refers to what came before.
    bool dropElements(const std::string &file) {
        bool hasChanged = false;
        for (std::size_t fromBack = 0; isInTime(); ++fromBack) {
            const auto xml = parseXml(m_world.files.at(file));
            if (!xml) break;
            const std::vector<XMLElement *> all = elementsOf(*xml);
            if (fromBack + 1 >= all.size()) break;
            XMLElement *element = all[all.size() - 1 - fromBack];
            element->Parent()->DeleteChild(element);
            if (!takeText(file, printXml(*xml))) continue;
            hasChanged = true;
            --fromBack;
        }
        return hasChanged;
    }

    bool simplifyElements(const std::string &file) {
        bool hasChanged = false;
        for (std::size_t i = 0; isInTime(); ++i) {
            const auto xml = parseXml(m_world.files.at(file));
            if (!xml || i >= elementsOf(*xml).size()) break;
            XMLElement &element = *elementsOf(*xml)[i];
            if (const tinyxml2::XMLAttribute *last = element.FirstAttribute()) {
                element.DeleteAttribute(last->Name());
                hasChanged = takeText(file, printXml(*xml)) || hasChanged;
            }
            for (const char *const simple : {"0", "1", "0 0 0 0 0 0"}) {
                const auto again = parseXml(m_world.files.at(file));
                XMLElement &leaf = *elementsOf(*again)[i];
                if (leaf.FirstChildElement() || !leaf.GetText() ||
                    std::string(leaf.GetText()).size() <= std::string(simple).size())
                    break;
                leaf.DeleteChildren();
                leaf.SetText(simple);
                if (!takeText(file, printXml(*again))) continue;
                hasChanged = true;
                break;
            }
        }
        return hasChanged;
    }

    bool dropBytes(const std::string &file) {
        bool hasChanged = false;
        for (std::size_t length = std::max<std::size_t>(1, m_world.files.at(file).size() / 2);
             length > 0 && isInTime(); length /= 2) {
            for (std::size_t end = m_world.files.at(file).size(); end > 0 && isInTime();) {
                const std::size_t begin = end > length ? end - length : 0;
                std::string shorter = m_world.files.at(file);
                if (end <= shorter.size())
                    hasChanged = takeText(file, shorter.erase(begin, end - begin)) || hasChanged;
                end = begin;
            }
        }
        return hasChanged;
    }

    WorldCase m_world;
    const std::function<bool(const WorldCase &)> &m_isInteresting;
    const Clock::time_point m_end;
};

}  // namespace

WorldCase shrunk(WorldCase world, const std::function<bool(const WorldCase &)> &isInteresting,
                 double seconds) {
    return Shrinking(std::move(world), isInteresting, seconds).run();
}

}  // namespace fuzz_worlds
