#include "shared_counters.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

// The linker's names for where a section begins and ends.
extern "C" {
extern std::uint8_t __start___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
extern std::uint8_t __stop___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
}

namespace fuzz {

SharedCounters::SharedCounters() {
    const auto begin = reinterpret_cast<std::uintptr_t>(__start___sancov_cntrs);
    const auto end = reinterpret_cast<std::uintptr_t>(__stop___sancov_cntrs);
    if (begin == end) throw std::runtime_error("no code was built with coverage counters");
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    m_pages = reinterpret_cast<std::uint8_t *>(begin / page * page);
    m_size = (end + page - 1) / page * page - begin / page * page;
    void *const shared = mmap(nullptr, m_size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory to share counters with");
    m_shared = static_cast<std::uint8_t *>(shared);
}

// The other variables on these pages keep their values, too.
void SharedCounters::share() const noexcept {
    std::memcpy(m_shared, m_pages, m_size);
    if (mremap(m_shared, m_size, m_size, MREMAP_MAYMOVE | MREMAP_FIXED, m_pages) == MAP_FAILED) _exit(1);
}

void SharedCounters::collect() const noexcept {
    std::memcpy(__start___sancov_cntrs, m_shared + (__start___sancov_cntrs - m_pages),
                static_cast<std::size_t>(__stop___sancov_cntrs - __start___sancov_cntrs));
}

}  // namespace fuzz
