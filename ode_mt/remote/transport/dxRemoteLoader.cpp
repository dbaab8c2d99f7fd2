#include "remote/transport/dxRemoteLoader.h"

#include <unistd.h>

namespace {

constexpr const char *kOwnFolder = "ode_mt/";  // of an installed tree, below that of libraries (ode/install/mpi.cmake)

std::string folderOfThisLibrary() {
    const std::string file = dxFindLibraryFile(reinterpret_cast<void *>(&folderOfThisLibrary));
    const std::size_t slash = file.rfind('/');
    return slash == std::string::npos ? std::string() : file.substr(0, slash + 1);
}

// Returns the library's path, or the name alone, for which the system's loader looks. (A file that exists and cannot be loaded, as MPI is missing,
// gives an error that says so.)
std::string find(const std::string &file) {
    const std::string folder = folderOfThisLibrary();
    for (const char *const place : {"", kOwnFolder})
        if (!folder.empty() && access((folder + place + file).c_str(), F_OK) == 0) return folder + place + file;
    return file;
}

}  // namespace

std::unique_ptr<dxRemoteTransport> dxLoadRemoteTransport(const char *name, unsigned wanted, std::string &reason) {
    const std::string file = std::string("libode_mt_") + name + ".so";
    void *const library = dlopen(find(file).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) {
        const char *const error = dlerror();
        reason = error != nullptr ? error : file + " cannot be loaded";
        return nullptr;
    }
    const auto open = reinterpret_cast<dxOpenRemoteTransportFunction *>(dlsym(library, "dxOpenRemoteTransport"));
    if (open == nullptr) {
        reason = file + " has no transport";
        return nullptr;
    }
    char text[512] = "";
    std::unique_ptr<dxRemoteTransport> transport(open(dxRemoteTransport::kInterfaceVersion, wanted, text, sizeof text));
    reason = text;  // also where there are fewer workers than wanted
    return transport;
}
