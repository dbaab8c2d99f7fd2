// XML that is not well-formed, or truncated by its contents, is an error: nothing of a world is ignored
// in silence.
#include "small_world.h"
#include "test_folder.h"

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

const std::string link = "<link name=\"a\"/>";
const std::string sdf = world("<model name=\"m\">" + link + "</model>");

std::string with(std::string text, const std::string &from, const std::string &to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::invalid_argument("no " + from);
    return text.replace(at, from.size(), to);
}

TEST(WellFormed, WhatStandsBeforeTheRootIsRead) {
    const std::string declaration = "<?xml version=\"1.0\"?>\n";
    EXPECT_NO_THROW(load("\xef\xbb\xbf" + sdf));
    EXPECT_NO_THROW(load(with(sdf, declaration, "<!-- no declaration -->")));
    EXPECT_NO_THROW(
        load(with(sdf, declaration, "<?xml version='1.0' encoding=\"utf-8\" standalone='yes'?>")));
    for (const char *const blank : {" ", "\n", "\r\n\t"}) EXPECT_NO_THROW(load(blank + sdf));
    expectError("\n\n<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n<world></sdf>", Kind::Syntax,
                {"not well-formed XML, line 5: mismatched tag"});
    for (const std::string &wrong :
         {"text " + declaration, declaration + "text", declaration + declaration,
          std::string("<?xml?>"), std::string("<?xml?>junk")})
        expectError(with(sdf, declaration, wrong), Kind::Syntax, {"test.sdf: not well-formed XML, line "});
    expectError(with(sdf, "1.0", "1.1"), Kind::Syntax, {"line 1: XML of version '1.1', not 1.0"});
    expectError(with(sdf, "\"1.0\"", "\"1.0\" encoding=\"UTF-16\""), Kind::Syntax,
                {"line 1: XML in encoding 'UTF-16'"});
    expectError(with(sdf, declaration, "<!DOCTYPE sdf [<!ENTITY a 'b'>]>"), Kind::Syntax,
                {"XML with a document type"});
    expectError(sdf + "text", Kind::Syntax, {"not well-formed XML"});
}

TEST(WellFormed, CommentsMayHoldHyphens) {
    EXPECT_NO_THROW(load(with(sdf, link, "<!-- run with --levels --><link name=\"a\"/><!----- b --->")));
    EXPECT_NO_THROW(load(with(sdf, link, "<link name=\"a--b\"/><![CDATA[ <!-- no --comment ]]>")));
    expectError(with(sdf, link, "<!-- without -- end" + link), Kind::Syntax, {"not well-formed XML"});
}

TEST(WellFormed, CdataMayStandBesideElements) {
    EXPECT_NO_THROW(load(with(sdf, link, "<![CDATA[ how to <run> this ]]>" + link)));
    expectError(with(sdf, link, "<![CDATA[ a ]]> b " + link), Kind::Value, {"/sdf/world/model[m]: holds text: "});
}

TEST(WellFormed, CharactersThatXmlDoesNotKnowAreErrors) {
    for (const std::string &name :
         {std::string("a&#0;b"), std::string("a&#27;b"),
          std::string("a\x01"
                      "b"),
          std::string("a\0b", 3),
          std::string("a\xff"
                      "b"),
          std::string("a\xe2\x80"), std::string("a<b"), std::string("a&b"), std::string("a&unknown;b")})
        expectError(with(sdf, "name=\"a\"", "name=\"" + name + "\""), Kind::Syntax,
                    {"test.sdf: not well-formed XML, line"});
    for (const char *const element : {"mass", "gravity", "self_collide"})
        expectError(
            with(sdf, link, "<link name=\"a\"><" + std::string(element) + ">1&#0;2</" + element + "></link>"),
            Kind::Syntax, {"not well-formed XML"});
}

TEST(WellFormed, NamesDepthAndListsOfAttributesHaveAnEnd) {
    const std::string longName(100000, 'y');
    expectError(with(sdf, "name=\"a\"", "name=\"a\" " + longName + "=\"1\""), Kind::Syntax,
                {"a name with 100000 characters"});
    std::string attributes;
    for (int i = 0; i < 20000; ++i) attributes += " a" + std::to_string(i) + "=\"1\"";
    expectError(with(sdf, "name=\"a\"", "name=\"a\"" + attributes), Kind::Syntax,
                {"an element with 20001 attributes"});
    for (const int depth : {95, 10000}) {
        std::string begins, ends;
        for (int i = 0; i < depth; ++i) begins += "<a>", ends += "</a>";
        expectError(with(sdf, link, begins + ends), Kind::Syntax, {"test.sdf: line ", "elements in one another"});
    }
}

std::string driven(const std::string &joints, const std::string &duration) {
    return world("<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", "1 0 0 0 0 0") +
                 "<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 "
                 "1</xyz></axis></joint>"
                 "<plugin name=\"p\" filename=\"odemt-velocity-schedule\"><joints>" +
                 joints + "</joints><phase duration=\"1\">" + duration + "</phase></plugin></model>");
}

TEST(WellFormed, TextIsReadWholeAcrossCommentsAndCdata) {
    EXPECT_NO_THROW(load(driven("<!-- all -->j", "<![CDATA[0]]><!-- rad/s -->")));
    EXPECT_NO_THROW(load(driven("<![CDATA[j]]>", "<![CDATA[0.]]>5")));
    expectError(driven("j<!-- -->k", "0"), Kind::Value, {"/plugin[p]/joints", "'k'"});
    expectError(driven("j<![CDATA[k]]>", "0"), Kind::Value, {"/plugin[p]/joints", "'jk'"});
    expectError(driven("j", "0<!-- --> 1"), Kind::Value, {"/plugin[p]/phase", "2 speeds"});
    expectError(driven("j", "0<![CDATA[ 1]]>"), Kind::Value, {"/plugin[p]/phase", "2 speeds"});
    expectError(with(driven("j", "0"), "<parent>a</parent>", "<parent>a<!-- -->x</parent>"), Kind::Value,
                {"/joint[j]/parent", "no frame 'a x'"});
    const std::string mesh = staticModel("s", "0 0 0 0 0 0", "<mesh><uri>a.obj<![CDATA[.nix]]></uri></mesh>");
    expectError(world(mesh), Kind::Resource, {"no file 'a.obj.nix'"});
}

TEST(WellFormed, IncludesAreReadWholeAcrossCommentsAndCdata) {
    const TestFolder folder("well_formed");
    folder.write("part/model.config",
                 "<?xml version=\"1.0\"?><model><sdf version=\"1.9\"><!-- the file "
                 "-->part<![CDATA[.sdf]]></sdf></model>");
    folder.write("part/part.sdf",
                 "<sdf version=\"1.9\"><model name=\"part\"><link name=\"l\"/></model></sdf>");
    const auto loadWith = [&](const std::string &include) {
        return worlds::loadWorldText(world("<include>" + include + "</include>"), folder.path("test.sdf"));
    };
    const auto scene =
        loadWith("<uri><!-- here -->pa<![CDATA[rt]]></uri><name><!-- new -->na<![CDATA[me]]></name>");
    EXPECT_EQ(scene->bodyNames(), std::vector<std::string>{"name::l"});
    EXPECT_THROW(loadWith("<uri>part<!-- -->/nix</uri>"), worlds::LoadError);
    EXPECT_THROW(loadWith("<uri>part</uri><placement_frame>l<!-- -->nix</placement_frame>"),
                 worlds::LoadError);
}

}  // namespace
