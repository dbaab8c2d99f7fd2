// Damaged worlds: loading them ends in a scene or in a LoadError, never in anything else.
#include "small_world.h"

#include "loader/load_world.h"
#include "support/text.h"
#include "support/text_file.h"

#include <random>

namespace {

using namespace small_world;

// A small world with something of everything.
const std::string base = world(R"(
  <frame name="f"><pose>0 0 1 0 0 0</pose></frame>
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
    </plane></geometry><surface><friction><ode><mu>0.5</mu></ode></friction></surface></collision></link></model>
  <model name="m"><pose relative_to="f">0 0 1 0.1 0.2 0.3</pose>
    <link name="a"><inertial><pose>0.1 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz>
      <ixy>0.1</ixy></inertia></inertial><collision name="c"><geometry><box><size>1 2 3</size></box></geometry>
      </collision></link>
    <link name="b"><pose>1 0 0 0 0 0</pose><collision name="c"><geometry><capsule><radius>0.1</radius>
      <length>1</length></capsule></geometry></collision></link>
    <joint name="j" type="universal"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz><limit><lower>-1</lower>
      <upper>1</upper><effort>3</effort></limit><dynamics><damping>0.1</damping></dynamics></axis>
      <axis2><xyz>0 1 0</xyz></axis2></joint>
    <plugin name="p" filename="odemt-velocity-schedule"><joints>j</joints><phase duration="1">0.5</phase></plugin>
  </model>)");

// True when the world loaded; it then has to run.
bool loads(const std::string &sdf) {
    try {
        const auto scene = load(sdf);
        run(*scene, 3);
        return true;
    } catch (const worlds::LoadError &error) {
        EXPECT_EQ(std::string(error.what()).find("test.sdf"), 0u) << error.what();
        return false;
    }
}

TEST(Malformed, TheUndamagedWorldLoads) { EXPECT_TRUE(loads(base)); }

TEST(Malformed, CutOffAnywhere) {
    for (std::size_t length = 0; length < base.size() - 10; length += 97)
        EXPECT_FALSE(loads(base.substr(0, length))) << "cut off at " << length;
}

TEST(Malformed, CharactersChanged) {
    std::mt19937 random(1);
    int loaded = 0;
    for (int i = 0; i < 80; ++i) {
        std::string damaged = base;
        for (int change = 0; change < 3; ++change)
            damaged[random() % damaged.size()] = static_cast<char>(32 + random() % 95);
        if (loads(damaged)) ++loaded;
    }
    EXPECT_LT(loaded, 80);
}

TEST(Malformed, NumbersReplaced) {
    const char *const numbers[] = {"nan", "-nan",   "inf",   "-inf", "1e400", "-1",
                                   "0",   "1e-320", "1e300", "0x10", ""};
    std::vector<std::pair<std::size_t, std::size_t>> places;  // begin and length of words with a digit
    for (std::size_t i = base.find("<world"); i < base.size();) {
        const std::size_t begin = base.find_first_of("-0123456789", i);
        if (begin == std::string::npos) break;
        const std::size_t end = base.find_first_of(" <\"\n", begin);
        places.emplace_back(begin, end - begin);
        i = end;
    }
    std::mt19937 random(2);
    for (int i = 0; i < 80; ++i) {
        const auto [begin, length] = places[random() % places.size()];
        std::string damaged = base;
        damaged.replace(begin, length, numbers[random() % std::size(numbers)]);
        SCOPED_TRACE(damaged.substr(begin > 40 ? begin - 40 : 0, 80));
        loads(damaged);
    }
}

TEST(Malformed, ElementsRemovedAndDoubled) {
    std::mt19937 random(3);
    std::vector<std::size_t> tags;
    for (std::size_t at = base.find('<'); at != std::string::npos; at = base.find('<', at + 1))
        tags.push_back(at);
    for (int i = 0; i < 80; ++i) {
        const std::size_t from = tags[1 + random() % (tags.size() - 2)];
        const std::size_t to = base.find('>', from) + 1;
        std::string damaged = base;
        if (i % 2 == 0)
            damaged.erase(from, to - from);
        else
            damaged.insert(from, base.substr(from, to - from));
        loads(damaged);
    }
}

TEST(Malformed, ElementsNestedDeeply) {
    std::string deep, end;
    for (int i = 0; i < 60; ++i) {
        deep += "<model name=\"m\"><link name=\"l\"/>";
        end += "</model>";
    }
    EXPECT_TRUE(loads(world(deep + end)));
}

// Lines of a benchmark world are removed, one at a time.
TEST(Malformed, LinesOfABenchmarkWorldLeftOut) {
    const std::string text = support::readTextFile(worlds::findWorld("create"));
    const std::vector<std::string> lines = support::split(text, '\n');
    for (std::size_t left = 1; left < lines.size(); left += 37) {
        std::string damaged;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (i != left) damaged += lines[i] + "\n";
        loads(damaged);
    }
}

}  // namespace
