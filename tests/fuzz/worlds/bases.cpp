#include "worlds/bases.h"

#include "support/temporary_folder.h"
#include "rule_world.h"
#include "worlds/asset_files.h"
#include "support/text_file.h"

#include <algorithm>

namespace fuzz_worlds {

namespace fs = std::filesystem;

namespace {

// One with something of everything: each kind of shape, joint, frame, include and controller.
const char *const kEverything = R"(<?xml version="1.0"?>
<sdf version="1.9" xmlns:odemt="urn:ode-mt:sdf">
  <world name="everything">
    <gravity>0 0.5 -9.81</gravity>
    <physics name="p" type="ode">
      <max_step_size>0.01</max_step_size>
      <max_contacts>8</max_contacts>
      <odemt:contact_candidates>30</odemt:contact_candidates>
      <odemt:space type="quadtree"><center>0 0 1</center><extents>10 10 10</extents><depth>3</depth></odemt:space>
      <odemt:auto_disable><linear_threshold>0.01</linear_threshold><idle_steps>5</idle_steps><average_samples>3</average_samples>
      </odemt:auto_disable>
      <odemt:damping><linear>0.001</linear><angular>0.002</angular></odemt:damping>
      <odemt:default_surface><bounce><restitution_coefficient>0.1</restitution_coefficient></bounce></odemt:default_surface>
      <ode>
        <solver><type>quick</type><iters>15</iters><sor>1.2</sor><friction_model>box_model</friction_model></solver>
        <constraints><cfm>1e-6</cfm><erp>0.3</erp><contact_max_correcting_vel>10</contact_max_correcting_vel>
          <contact_surface_layer>0.001</contact_surface_layer></constraints>
      </ode>
    </physics>
    <frame name="f"><pose>0 0 1 0 0 0</pose></frame>
    <frame name="g" attached_to="f"><pose degrees="true">0 1 0 0 0 90</pose></frame>
    <model name="ground"><static>true</static>
      <link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal></plane></geometry>
        <surface><friction><ode><mu>0.5</mu><mu2>0.7</mu2><slip1>0.01</slip1><fdir1>1 0 0</fdir1></ode></friction>
          <contact><ode><soft_cfm>0.001</soft_cfm><soft_erp>0.3</soft_erp></ode></contact></surface></collision></link>
    </model>
    <model name="hills"><static>true</static><pose>5 5 0 0 0 0</pose>
      <link name="l"><collision name="c"><geometry><heightmap><uri>hills.pgm</uri><size>4 4 1</size></heightmap></geometry></collision></link>
    </model>
    <model name="m"><pose relative_to="g">0 0 1 0.1 0.2 0.3</pose><self_collide>true</self_collide>
      <frame name="inner" attached_to="b"><pose>0.1 0 0 0 0 0</pose></frame>
      <link name="a"><velocity_decay><linear>0.01</linear></velocity_decay>
        <inertial><pose>0.1 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0.1</ixy></inertia></inertial>
        <collision name="c"><geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision>
        <collision name="d"><pose>0 0 0.2 0 0 0</pose><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link>
      <link name="b"><pose>1 0 0 0 0 0</pose>
        <collision name="c"><geometry><capsule><radius>0.1</radius><length>1</length></capsule></geometry></collision></link>
      <link name="d"><pose relative_to="inner">0 1 0 0 0 0</pose>
        <collision name="c"><geometry><cylinder><radius>0.1</radius><length>1</length></cylinder></geometry></collision></link>
      <link name="e"><collision name="c"><geometry><mesh><uri>shape.obj</uri><scale>0.1 0.1 0.2</scale></mesh></geometry></collision></link>
      <joint name="j" type="revolute"><parent>a</parent><child>b</child>
        <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>3</effort><velocity>9</velocity></limit>
          <dynamics><damping>0.1</damping><friction>0.01</friction><spring_stiffness>2</spring_stiffness></dynamics></axis></joint>
      <joint name="k" type="revolute2"><parent>b</parent><child>d</child><axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>
        <physics><ode><suspension><cfm>0.01</cfm><erp>0.4</erp></suspension></ode></physics></joint>
      <joint name="u" type="universal"><parent>d</parent><child>e</child><axis><xyz>0 0 1</xyz></axis>
        <axis2><xyz expressed_in="inner">0 1 0</xyz></axis2></joint>
      <plugin name="water" filename="odemt-fluid"><surface>1</surface><density>900</density><immersed link="b">
        <size>0.2 0.2 1</size><center>0 0 0.1</center><drag>1 1 2</drag><spin_drag>0.01</spin_drag></immersed></plugin>
      <plugin name="flight" filename="odemt-body-forces"><link>e</link><linear_drag>0.1 0 0 0 0.01 0</linear_drag>
        <quadratic_drag>0 0.2 0 0.01 0 0</quadratic_drag><righting_moment>0.3</righting_moment><phase duration="0.1">0 0 1 0 0.1 0</phase>
        <repeat count="2"><phase duration="0.05">1 0 0 0 0 -0.1</phase></repeat></plugin>
      <plugin name="q" filename="odemt-position-schedule"><gain>5</gain><joints>u</joints><hold duration="0.1">0.2</hold>
        <repeat><glide duration="0.2">-0.1</glide><swing duration="0.2" frequency="3"><center>0.1</center>
        <amplitude>0.3</amplitude><phase>0.25</phase><growth>0 1</growth></swing></repeat></plugin>
      <plugin name="p" filename="odemt-velocity-schedule"><joints>j u/axis2</joints><phase duration="1">0.5 0.1</phase>
        <repeat count="3"><phase duration="0.1">0.1 0.2</phase></repeat><repeat><phase duration="0.1">-0.1 0</phase></repeat></plugin>
      <model name="nested"><pose>0 0 2 0 0 0</pose><link name="x"/><link name="y"><pose>0 0 1 0 0 0</pose></link>
        <joint name="s" type="prismatic"><parent>x</parent><child>y</child><axis><xyz>0 0 1</xyz><limit><upper>1e16</upper></limit></axis></joint>
        <joint name="t" type="fixed"><parent>world</parent><child>x</child></joint>
        <plugin name="p" filename="odemt-random-cycle"><joints>s</joints><control_step>0.02</control_step><cycle>10</cycle>
          <first_part start="3" least="1" most="5">0.1</first_part><second_part>-0.1</second_part><seed>7</seed></plugin></model>
    </model>
    <include><uri>model://part</uri><name>first</name><pose>3 0 1 0 0 0</pose></include>
    <include><uri>model://part</uri><name>second</name><pose relative_to="f">3 3 1 0 0 0</pose><placement_frame>tip</placement_frame></include>
    <include><uri>wall.sdf</uri><static>true</static></include>
  </world>
</sdf>
)";

const char *const kPart = R"(<?xml version="1.0"?>
<sdf version="1.7"><model name="part">
  <link name="base"><collision name="c"><geometry><mesh><uri>model://part/meshes/part.stl</uri></mesh></geometry></collision></link>
  <link name="tip"><pose>0 0 0.5 0 0 0</pose><collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision></link>
  <joint name="j" type="ball"><parent>base</parent><child>tip</child></joint>
  <joint name="h" type="continuous"><parent>base</parent><child>tip</child><axis><xyz>1 0 0</xyz></axis></joint>
  <plugin name="p" filename="odemt-fourier-gait"><gain>5</gain><frequency>2</frequency>
    <wave name="w"><constant>0.1</constant><cos>0.1 0.2</cos><sin>0.3</sin></wave><swing joint="h" wave="w" phase="0.25"/></plugin>
</model></sdf>
)";

const char *const kPartConfig = R"(<?xml version="1.0"?>
<model><name>part</name><version>1.0</version><sdf version="1.7">model.sdf</sdf></model>
)";

const char *const kWall =
    R"(<sdf version="1.5"><model name="wall"><pose>0 9 1 0 0 0</pose><link name="l"><collision name="c">
  <geometry><box><size>9 0.1 2</size></box></geometry></collision></link></model></sdf>
)";

WorldCase everything() {
    WorldCase world;
    world.name = "everything";
    world.files = {{kWorldFile, kEverything},
                   {"models/part/model.sdf", kPart},
                   {"models/part/model.config", kPartConfig},
                   {"wall.sdf", kWall},
                   {"hills.pgm", greyImage()},
                   {"shape.obj", objMesh()},
                   {"models/part/meshes/part.stl", binaryStlMesh()}};
    return world;
}

// A world of one geometry that is read from a file.
WorldCase withFile(const std::string &geometry, const std::string &file, const std::string &text) {
    WorldCase world;
    world.name = file;
    world.files[file] = text;
    world.files[kWorldFile] =
        "<sdf version=\"1.9\"><world name=\"w\"><model name=\"m\"><static>true</static><link name=\"l\">"
        "<collision name=\"c\"><geometry><" +
        geometry + "><uri>" + file + "</uri></" + geometry +
        "></geometry></collision></link></model><model name=\"ball\"><link name=\"l\"><pose>0.2 0.2 0.3 0 0 "
        "0</pose>"
        "<collision name=\"c\"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link>"
        "</model></world></sdf>\n";
    return world;
}

// The files that a world of the repository names: all models beside it.
WorldCase fromFile(const fs::path &file) {
    WorldCase world;
    world.name = file.filename().string();
    world.files[kWorldFile] = support::readWhatIsThere(file);
    const fs::path folder = file.parent_path();
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder / "models"))
        if (entry.is_regular_file() &&
            world.world().find("model://" + entry.path().parent_path().filename().string()) !=
                std::string::npos)
            world.files[fs::relative(entry.path(), folder).string()] = support::readWhatIsThere(entry.path());
    return world;
}

WorldCase ofRule(const worlds::NamedRule &rule) {
    WorldCase world;
    world.name = rule.path;
    rule_world::RuleWorld made(rule);
    made.addCompany();
    world.files[kWorldFile] = made.text();
    for (const auto &[file, text] :
         {std::pair<std::string, std::string>{"cube.obj", objMesh()},
          {"flat.pgm", greyImage()},
          {"part.sdf", "<sdf version=\"1.9\"><model name=\"part\"><link name=\"l\"/></model></sdf>"}})
        if (world.world().find(file) != std::string::npos) world.files[file] = text;
    return world;
}

}  // namespace

Bases readBases(const fs::path &worldFolder) {
    Bases bases;
    for (const fs::directory_entry &entry : fs::directory_iterator(worldFolder))
        if (entry.path().extension() == ".sdf") bases.large.push_back(fromFile(entry.path()));
    std::sort(bases.large.begin(), bases.large.end(),
              [](const WorldCase &a, const WorldCase &b) { return a.name < b.name; });
    bases.small.push_back(everything());
    for (const auto &[file, text] : assetFiles())
        bases.small.push_back(withFile(isImage(file) ? "heightmap" : "mesh", file, text));
    for (const worlds::NamedRule &rule : worlds::elementRules())
        if (rule.rule.use == worlds::Use::Read && rule.path != "/sdf") bases.small.push_back(ofRule(rule));
    return bases;
}

}  // namespace fuzz_worlds
