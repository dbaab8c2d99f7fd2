// This process's slots of the file that ODE_MT_STATISTICS names (dxStatisticsFile.h).
//
// Threading: under the lock of dxWorldStatistics.
#pragma once

#include <cstddef>

struct dxStatisticsFile;
struct dxStatisticsSlot;

class dxStatisticsSharing {
public:
    // Of a new world; null: there is no file, or no free slot in it.
    dxStatisticsSlot *claim();

    static void giveBack(dxStatisticsSlot *slot);

    // What kept the file from being used, once; empty: nothing.
    const char *takeComplaint();

    void close();

private:
    void open();

    dxStatisticsFile *m_file = nullptr;
    bool m_isOpened = false;  // or was tried to
    char m_complaint[400] = "";
    bool m_hasComplaint = false;
};
