// The threads of this process that are not ending.
#pragma once

#include <dirent.h>

#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include "Runs.h"

// The kernel lists a thread for a while after pthread_join has returned for it. By then the flags in its
// stat (proc(5), the seventh field after the name) say that it is exiting.
inline bool isEnding(const std::string &task) {
    constexpr unsigned exiting = 0x4;  // PF_EXITING of the kernel's include/linux/sched.h
    std::ifstream stat("/proc/self/task/" + task + "/stat");
    stat.ignore(std::numeric_limits<std::streamsize>::max(), ')');
    std::string field;
    for (int i = 0; i < 6; ++i) stat >> field;
    unsigned flags = 0;
    return !(stat >> flags) || (flags & exiting) != 0;
}

inline unsigned processThreads() {
    // With the first one ThreadSanitizer starts one of its own.
    static const bool isBegun = (std::thread([] {}).join(), true);
    static_cast<void>(isBegun);
    unsigned count = 0;
    DIR *tasks = opendir("/proc/self/task");
    while (const dirent *entry = readdir(tasks)) {
        count += entry->d_name[0] != '.' && !isEnding(entry->d_name);
    }
    closedir(tasks);
    return count;
}

// Threads that end without being joined take a moment.
inline bool threadsFallTo(unsigned count) {
    return waitUntil([=] { return processThreads() <= count; }, 5);
}
