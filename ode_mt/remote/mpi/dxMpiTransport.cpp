#include "remote/mpi/dxMpiTransport.h"

#include <dlfcn.h>
#include <unistd.h>

#include <climits>
#include <cstdio>

namespace {

constexpr int kTag = 20773;  // of all messages; a program that uses MPI itself has others

// The worker's program: beside this library, as in the build's folder, or in bin/ beside the library's folder, else wherever the system finds it.
std::string findWorkerProgram() {
    const std::string name = "odemt_worker";
    Dl_info info;
    if (dladdr(reinterpret_cast<void *>(&findWorkerProgram), &info) == 0 || info.dli_fname == nullptr) return name;
    const std::string file = info.dli_fname;
    for (std::size_t slash = file.rfind('/'); slash != std::string::npos && slash > 0; slash = file.rfind('/', slash - 1)) {
        for (const char *const place : {"/", "/bin/"}) {
            const std::string program = file.substr(0, slash) + place + name;
            if (access(program.c_str(), X_OK) == 0) return program;
        }
    }
    return name;
}

std::string textOf(int error) {
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(error, text, &length);
    return text;
}

}  // namespace

bool dxMpiTransport::initialise(std::string &reason) {
    int isInitialised = 0, isFinalised = 0, level = 0;
    MPI_Initialized(&isInitialised);
    MPI_Finalized(&isFinalised);
    if (isFinalised) {
        reason = "the program has ended MPI";
        return false;
    }
    if (isInitialised) {
        MPI_Query_thread(&level);
        if (level == MPI_THREAD_MULTIPLE) return true;
        reason = "the program uses MPI itself, without MPI_THREAD_MULTIPLE";
        return false;
    }
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS || level < MPI_THREAD_FUNNELED) {
        reason = "MPI cannot be initialised for a program with threads";
        return false;
    }
    m_isOwn = true;
    return true;
}

std::unique_ptr<dxMpiTransport> dxMpiTransport::openHome(unsigned wanted, std::string &reason) {
    std::unique_ptr<dxMpiTransport> transport(new dxMpiTransport);
    if (!transport->initialise(reason)) return nullptr;
    if (wanted > 0) {
        if (!transport->spawn(wanted, reason)) return nullptr;
        return transport;
    }
    int rank = 0, size = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (rank != 0 || size < 2) {
        reason = rank != 0 ? "the program is not the first process of its job" : "there is no other process in its job";
        transport->close(false);
        return nullptr;
    }
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    for (int worker = 1; worker < size; ++worker) transport->m_links.push_back({MPI_COMM_WORLD, worker});
    transport->m_probed = {MPI_COMM_WORLD};
    return transport;
}

// One after the other: processes that are spawned together are one job.
bool dxMpiTransport::spawn(unsigned wanted, std::string &reason) {
    m_isSpawned = true;
    MPI_Comm_set_errhandler(MPI_COMM_SELF, MPI_ERRORS_RETURN);
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    const std::string program = findWorkerProgram();
    for (unsigned i = 0; i < wanted; ++i) {
        MPI_Comm worker = MPI_COMM_NULL;
        int error = MPI_SUCCESS;
        const int result = MPI_Comm_spawn(program.c_str(), MPI_ARGV_NULL, 1, MPI_INFO_NULL, 0, MPI_COMM_SELF, &worker, &error);
        if (result != MPI_SUCCESS || worker == MPI_COMM_NULL) {
            reason = program + " cannot be started: " + textOf(result);
            break;
        }
        MPI_Comm_set_errhandler(worker, MPI_ERRORS_RETURN);
        m_links.push_back({worker, 0});
        m_probed.push_back(worker);
    }
    return !m_links.empty();
}

std::unique_ptr<dxMpiTransport> dxMpiTransport::openWorker(std::string &reason) {
    std::unique_ptr<dxMpiTransport> transport(new dxMpiTransport);
    if (!transport->initialise(reason)) return nullptr;
    MPI_Comm parent = MPI_COMM_NULL;
    MPI_Comm_get_parent(&parent);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    transport->m_isSpawned = parent != MPI_COMM_NULL;
    if (!transport->m_isSpawned && rank == 0) {
        reason = "there is no program whose worker this process is: mpirun -np 1 PROGRAM : -np N odemt_worker";
        transport->close(false);
        return nullptr;
    }
    const MPI_Comm communicator = transport->m_isSpawned ? parent : MPI_COMM_WORLD;
    MPI_Comm_set_errhandler(communicator, MPI_ERRORS_RETURN);
    transport->m_links.push_back({communicator, 0});
    transport->m_probed = {communicator};
    return transport;
}

void dxMpiTransport::forgetSent() {
    for (auto sending = m_sending.begin(); sending != m_sending.end();) {
        int isComplete = 0;
        if (MPI_Test(&sending->request, &isComplete, MPI_STATUS_IGNORE) == MPI_SUCCESS && !isComplete)
            ++sending;
        else
            sending = m_sending.erase(sending);
    }
}

bool dxMpiTransport::send(unsigned link, const void *message, std::size_t bytes) {
    forgetSent();
    if (bytes > INT_MAX) return false;
    const char *const from = static_cast<const char *>(message);
    m_sending.push_back({std::vector<char>(from, from + bytes), MPI_REQUEST_NULL});
    Sending &sending = m_sending.back();
    const Link &to = m_links[link];
    if (MPI_Isend(sending.bytes.data(), static_cast<int>(bytes), MPI_BYTE, to.rank, kTag, to.communicator, &sending.request) == MPI_SUCCESS) return true;
    m_sending.pop_back();
    return false;
}

std::size_t dxMpiTransport::waiting(unsigned &link) {
    if (!m_sending.empty()) forgetSent();
    const unsigned count = static_cast<unsigned>(m_probed.size());
    for (unsigned i = 0; i < count; ++i) {
        const unsigned one = (m_next + i) % count;
        int isThere = 0;
        MPI_Status status;
        if (MPI_Improbe(MPI_ANY_SOURCE, kTag, m_probed[one], &isThere, &m_message, &status) != MPI_SUCCESS || !isThere) continue;
        m_next = one + 1;
        MPI_Get_count(&status, MPI_BYTE, &m_bytes);
        link = m_isSpawned ? one : m_links.size() == 1 ? 0 : static_cast<unsigned>(status.MPI_SOURCE - 1);
        return static_cast<std::size_t>(m_bytes);
    }
    return 0;
}

bool dxMpiTransport::receive(void *message) { return MPI_Mrecv(message, m_bytes, MPI_BYTE, &m_message, MPI_STATUS_IGNORE) == MPI_SUCCESS; }

// Without the others MPI_Finalize would wait for them for ever.
void dxMpiTransport::close(bool isOrderly) {
    for (int attempt = 0; attempt < 100 && !m_sending.empty(); ++attempt) {
        forgetSent();
        if (!m_sending.empty()) usleep(1000);
    }
    if (!isOrderly && m_links.empty()) isOrderly = m_isOwn;  // nothing has been agreed upon with anybody
    if (!isOrderly) {
        new std::list<Sending>(std::move(m_sending));  // MPI may read them until the process ends
        return;
    }
    if (m_isSpawned)
        for (Link &link : m_links) MPI_Comm_disconnect(&link.communicator);
    if (m_isOwn) MPI_Finalize();
}
