// What libode_mt_mpi.so exports.
#include <cstdio>

#include "remote/mpi/dxMpiTransport.h"

extern "C" __attribute__((visibility("default"))) dxRemoteTransport *dxOpenRemoteTransport(unsigned interfaceVersion, unsigned wanted, char *reason,
                                                                                         std::size_t reasonSize) {
    std::string text;
    std::unique_ptr<dxMpiTransport> transport;
    if (interfaceVersion != dxRemoteTransport::kInterfaceVersion)
        text = "libode_mt_mpi.so is of another version than the library";
    else
        transport = dxMpiTransport::openCoordinator(wanted, text);
    std::snprintf(reason, reasonSize, "%s", text.c_str());
    return transport.release();
}
