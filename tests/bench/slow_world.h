// A world file that takes seconds to load.
#pragma once

#include <fstream>
#include <string>

// A world of so many models that it loads for longer than the test waits.
inline std::string slowWorld(const std::string &folder) {
    std::ofstream part(folder + "/part.sdf"), world(folder + "/slow.sdf");
    part << "<sdf version=\"1.6\"><model name=\"p\"><static>1</static>";
    for (int i = 0; i < 40; ++i)
        part << "<link name=\"l" << i << "\"><collision name=\"c\"><geometry><sphere/></geometry></collision></link>";
    part << "</model></sdf>";
    world << "<sdf version=\"1.6\"><world name=\"w\">";
    for (int i = 0; i < 15000; ++i) world << "<include><uri>part.sdf</uri><name>m" << i << "</name></include>";
    world << "</world></sdf>";
    return folder + "/slow.sdf";
}
