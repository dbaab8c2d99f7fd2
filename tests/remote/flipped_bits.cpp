// libodemt_flipped_bits.so, which is loaded before MPI's library (LD_PRELOAD): in odemt_worker it counts messages, and flips a bit of one where the
// program that is tested asks for that (FaultTable). In other programs it does nothing.
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "fault_table.h"

namespace {

FaultTable::Worker *own = nullptr;

__attribute__((constructor)) void begin() {
    char program[4096] = "";
    const char *const file = std::getenv(FaultTable::kVariable);
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    const char *const name = length > 0 ? std::strrchr(program, '/') : nullptr;
    if (file == nullptr || name == nullptr || std::strcmp(name, "/odemt_worker") != 0) return;
    const int descriptor = open(file, O_RDWR);
    if (descriptor < 0) return;
    FaultTable *const table = FaultTable::map(descriptor);
    if (table == nullptr) return;
    const unsigned index = table->count++;
    if (index >= FaultTable::kMaxWorkers) return;
    own = &table->workers[index];
    own->process = getpid();
}

}  // namespace

extern "C" __attribute__((visibility("default"))) int MPI_Isend(const void *data, int count, MPI_Datatype type, int to, int tag,
                                                                MPI_Comm communicator, MPI_Request *request) {
    if (own != nullptr) {
        if (const unsigned bit = own->wantFlip.exchange(0)) {
            auto *const bytes = static_cast<unsigned char *>(const_cast<void *>(data));  // the transport's copy
            bytes[bit / 8 % static_cast<unsigned>(count)] ^= static_cast<unsigned char>(1u << bit % 8);
            ++own->flipped;
        }
        ++own->sent;
    }
    return PMPI_Isend(data, count, type, to, tag, communicator, request);
}
