#include "remote/mpi/dxMpiHelp.h"

#include <dlfcn.h>
#include <mpi.h>

#include <cstdarg>
#include <cstring>

#include "remote/transport/dxLibraryFile.h"

namespace {

// Variables of Open MPI's base library (opal/util/show_help.h of versions 4.0 and 4.1): the function that every part calls with a help text, and
// the one that writes it to standard error.
using ShowHelp = int(const char *file, const char *topic, int hasHeader, ...);
using WriteHelp = int(const char *file, const char *topic, bool hasHeader, va_list values);

WriteHelp **s_write = nullptr;

int writeHere(const char *file, const char *topic, int hasHeader, ...) {
    va_list values;
    va_start(values, hasHeader);
    const int result = (*s_write)(file, topic, (hasHeader & 0xff) != 0, values);
    va_end(values);
    return result;
}

bool isOpenMpi4() {
    char version[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    MPI_Get_library_version(version, &length);
    return std::strncmp(version, "Open MPI v4.", 12) == 0;
}

}  // namespace

void dxWriteMpiHelpHere() {
    if (!isOpenMpi4()) return;
    void *const mpi = dlopen(dxFindLibraryFile(reinterpret_cast<void *>(&MPI_Init)).c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (mpi == nullptr) return;
    const auto show = static_cast<ShowHelp **>(dlsym(mpi, "opal_show_help"));
    s_write = static_cast<WriteHelp **>(dlsym(mpi, "opal_show_vhelp"));
    if (show != nullptr && s_write != nullptr) __atomic_store_n(show, &writeHere, __ATOMIC_RELEASE);
}
