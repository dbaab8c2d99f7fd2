#include "remote/dxRemoteLoader.h"

#include <dlfcn.h>

namespace {

std::string folderOfThisLibrary() {
    Dl_info info;
    if (dladdr(reinterpret_cast<void *>(&folderOfThisLibrary), &info) == 0 || info.dli_fname == nullptr) return {};
    const std::string file = info.dli_fname;
    const std::size_t slash = file.rfind('/');
    return slash == std::string::npos ? std::string() : file.substr(0, slash + 1);
}

void *load(const std::string &file) { return dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE); }

}  // namespace

std::unique_ptr<dxRemoteTransport> dxLoadRemoteTransport(const char *name, unsigned wanted, std::string &reason) {
    const std::string file = std::string("libode_mt_") + name + ".so", folder = folderOfThisLibrary();
    void *library = folder.empty() ? nullptr : load(folder + file);
    if (library == nullptr) library = load(file);
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
