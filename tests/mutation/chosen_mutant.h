// Included before every source file of a library with mutants (tests/mutation/run).
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>

// Which mutant the process has: the variable ODE_MT_MUTANT has its number. Where ODE_MT_REACHED names a file, it gets a byte that
// is not zero at the number of each that was asked for, by this process or any other.
class dxMutants {
public:
    static bool isChosen(int number) {
        static const dxMutants mutants;
        if (mutants.m_reached != nullptr) mutants.m_reached[number] = 1;
        return number == mutants.m_chosen;
    }

private:
    dxMutants() {
        const char *const chosen = std::getenv("ODE_MT_MUTANT");
        if (chosen != nullptr) m_chosen = std::atoi(chosen);
        const char *const name = std::getenv("ODE_MT_REACHED");
        const int file = name != nullptr ? open(name, O_RDWR | O_CLOEXEC) : -1;
        if (file < 0) return;
        const off_t length = lseek(file, 0, SEEK_END);
        void *const shared = mmap(nullptr, static_cast<std::size_t>(length), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        if (shared != MAP_FAILED) m_reached = static_cast<volatile char *>(shared);
    }

    int m_chosen = 0;
    volatile char *m_reached = nullptr;
};

inline bool dxMutant(int number) { return dxMutants::isChosen(number); }
