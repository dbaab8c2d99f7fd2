#include "remote/mpi/dxMpiTransport.h"

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <thread>
#include <utility>

#include "core/dxGuards.h"
#include "remote/transport/dxRemoteLoader.h"

namespace {

constexpr int kTag = 20773;  // of all messages; a program that uses MPI itself has others

constexpr const char *kWorker = "odemt_worker";

// Returns the path of a program in a folder of PATH; empty: in none.
std::string findOnPath(const char *name) {
    const char *const path = std::getenv("PATH");
    for (std::string folders = path != nullptr ? path : ""; !folders.empty();) {
        const std::size_t end = folders.find(':');
        const std::string program = folders.substr(0, end) + "/" + name;
        if (access(program.c_str(), X_OK) == 0) return program;
        folders = end == std::string::npos ? "" : folders.substr(end + 1);
    }
    return "";
}

// Returns the worker's program: beside this library, as in the build's folder, or in bin/ beside one of the folders around it, as installed, else on
// the PATH. Empty: it is in none of these, and MPI would end the program, or wait for ever.
std::string findWorkerProgram() {
    const std::string name = kWorker, file = dxFindLibraryFile(reinterpret_cast<void *>(&findWorkerProgram));
    for (std::size_t slash = file.rfind('/'); slash != std::string::npos && slash > 0; slash = file.rfind('/', slash - 1)) {
        for (const char *const place : {"/", "/bin/"}) {
            const std::string program = file.substr(0, slash) + place + name;
            if (access(program.c_str(), X_OK) == 0) return program;
        }
    }
    return findOnPath(kWorker);
}

// Returns whether mpirun lets the others live when one process ends: --enable-recovery of Open MPI 4, --with-ft ulfm of Open MPI 5. Both tell
// processes by their environment.
bool doesJobSurvive() {
    for (const char *const name : {"OMPI_MCA_orte_enable_recovery", "OMPI_MCA_mpi_ft_enable"}) {
        const char *const value = std::getenv(name);
        if (value != nullptr && std::strcmp(value, "0") != 0 && std::strcmp(value, "false") != 0) return true;
    }
    return false;
}

// Open MPI's processes listen at the first port that is free from 1024 on, so that a new worker would have a lost one's, to which the
// coordinator may still try to connect: both then wait for ever. Each gets ports of its own, unless the user has chosen.
void listenElsewhere() {
    constexpr unsigned kFirst = 20000, kCount = 12000;
    char port[16];
    std::snprintf(port, sizeof port, "%u", kFirst + static_cast<unsigned>(getpid()) % kCount);
    setenv("OMPI_MCA_btl_tcp_port_min_v4", port, 0);
    setenv("OMPI_MCA_btl_tcp_port_min_v6", port, 0);
}

// By default Open MPI starts no more workers than there are cores, even if the user wants more, and binds each of them, a job of its own, to the
// first core. Other MPIs do not know the keys.
MPI_Info howToSpawn() {
    MPI_Info info = MPI_INFO_NULL;
    MPI_Info_create(&info);
    MPI_Info_set(info, "map_by", "slot:OVERSUBSCRIBE");
    MPI_Info_set(info, "bind_to", "none");
    return info;
}

int spawnOne(const std::string &program, MPI_Comm &worker) {
    worker = MPI_COMM_NULL;
    int error = MPI_SUCCESS;
    MPI_Info info = howToSpawn();
    const int result = MPI_Comm_spawn(program.c_str(), MPI_ARGV_NULL, 1, info, 0, MPI_COMM_SELF, &worker, &error);
    MPI_Info_free(&info);
    if (worker != MPI_COMM_NULL) MPI_Comm_set_errhandler(worker, MPI_ERRORS_RETURN);
    return result;
}

std::string textOf(int error) {
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(error, text, &length);
    return text;
}

// Exists while MPI begins on this thread, and while it starts the first worker: a process that MPI forks then has no files of the program but
// standard output and error. Without mpirun Open MPI starts a server, in MPI_Init (4: orted) or in the first MPI_Comm_spawn (5: prte). It would read
// the program's standard input for the workers, and the program would lose what it has read (its key ompi_stdin_target ends Open MPI 4.1's server).
// It would also keep the program's pipes open, whose other ends would never see their end.
class NoFilesForChildren {
public:
    NoFilesForChildren() {
        static const int isListening = pthread_atfork(nullptr, nullptr, closeFiles);
        static_cast<void>(isListening);
        noteFiles();
        s_isActive = true;
    }
    ~NoFilesForChildren() {
        s_isActive = false;
        s_files = {};
    }
    NoFilesForChildren(const NoFilesForChildren &) = delete;
    NoFilesForChildren &operator=(const NoFilesForChildren &) = delete;

private:
    // Another thread may close a file. If Open MPI's own pipe to the child then gets its number, it is another file.
    struct File {
        int number;
        struct stat status;
    };

    static void noteFiles() {
        const std::unique_ptr<DIR, int (*)(DIR *)> folder(opendir("/proc/self/fd"), closedir);
        if (folder == nullptr) return;
        while (const dirent *const entry = readdir(folder.get())) {
            File file{std::atoi(entry->d_name), {}};
            if (file.number > STDERR_FILENO && file.number != dirfd(folder.get()) && fstat(file.number, &file.status) == 0) s_files.push_back(file);
        }
    }

    static bool isOpen(const File &file) {
        struct stat status;
        return fstat(file.number, &status) == 0 && status.st_dev == file.status.st_dev && status.st_ino == file.status.st_ino;
    }

    // In the child, which goes on to execute another program.
    static void closeFiles() {
        if (!s_isActive) return;
        for (const File &file : s_files)
            if (isOpen(file)) fcntl(file.number, F_SETFD, FD_CLOEXEC);
        const int none = open("/dev/null", O_RDONLY);
        if (none <= STDIN_FILENO) return;
        dup2(none, STDIN_FILENO);
        ::close(none);
    }

    static inline thread_local bool s_isActive = false;
    static inline thread_local std::vector<File> s_files;
};

// --- help texts of Open MPI, such as the one that a peer has hung up ------------------------------------------------
//
// Open MPI 4 sends them to mpirun (or orted), which reads a message after it has told another thread to free it (orte_rml_oob_send_buffer_nb gives it
// away before it copies it): now and then mpirun crashes, and ends the job that should survive a lost worker. So this process writes its own to
// standard error. Other versions of MPI are left alone.

// Variables of Open MPI's base library (opal/util/show_help.h of versions 4.0 and 4.1): the function that every part calls with a help text, and
// the one that writes it to standard error.
using ShowHelp = int(const char *file, const char *topic, int hasHeader, ...);
using WriteHelp = int(const char *file, const char *topic, bool hasHeader, va_list values);

WriteHelp **s_writeHelp = nullptr;

int writeHelpHere(const char *file, const char *topic, int hasHeader, ...) {
    va_list values;
    va_start(values, hasHeader);
    const int result = (*s_writeHelp)(file, topic, (hasHeader & 0xff) != 0, values);
    va_end(values);
    return result;
}

bool isOpenMpi4() {
    char version[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    MPI_Get_library_version(version, &length);
    return std::strncmp(version, "Open MPI v4.", 12) == 0;
}

// Requires that MPI has been initialised.
void haveHelpWrittenHere() {
    if (!isOpenMpi4()) return;
    void *const mpi = dlopen(dxFindLibraryFile(reinterpret_cast<void *>(&MPI_Init)).c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (mpi == nullptr) return;
    const auto show = static_cast<ShowHelp **>(dlsym(mpi, "opal_show_help"));
    s_writeHelp = static_cast<WriteHelp **>(dlsym(mpi, "opal_show_vhelp"));
    if (show != nullptr && s_writeHelp != nullptr) __atomic_store_n(show, &writeHelpHere, __ATOMIC_RELEASE);
}

}  // namespace

struct dxMpiTransport::Start {
    unsigned link = 0;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::atomic<bool> hasEnded{false};
    MPI_Comm worker = MPI_COMM_NULL;  // null at the end: it could not be started
};

bool dxMpiTransport::initialise(int wantedLevel, std::string &reason) {
    int isInitialised = 0, isFinalised = 0, level = 0;
    MPI_Initialized(&isInitialised);
    MPI_Finalized(&isFinalised);
    if (isFinalised) {
        reason = "the program has ended MPI";
        return false;
    }
    if (isInitialised) {
        MPI_Query_thread(&level);
        if (level != MPI_THREAD_MULTIPLE) {
            reason = "the program uses MPI itself, without MPI_THREAD_MULTIPLE";
            return false;
        }
    } else {
        const NoFilesForChildren noFiles;
        if (MPI_Init_thread(nullptr, nullptr, wantedLevel, &level) != MPI_SUCCESS || level < MPI_THREAD_FUNNELED) {
            reason = "MPI cannot be initialised for a program with threads";
            return false;
        }
        m_isOwn = true;
    }
    haveHelpWrittenHere();
    m_isForAllThreads = level >= MPI_THREAD_SERIALIZED;
    m_canReplace = level == MPI_THREAD_MULTIPLE && doesJobSurvive();
    return true;
}

std::unique_ptr<dxMpiTransport> dxMpiTransport::openCoordinator(unsigned wanted, std::string &reason) {
    std::unique_ptr<dxMpiTransport> transport(new dxMpiTransport);
    if (!transport->initialise(wanted > 0 ? MPI_THREAD_MULTIPLE : MPI_THREAD_SERIALIZED, reason)) return nullptr;
    if (wanted > 0) {
        if (!transport->spawn(wanted, reason)) return nullptr;
        return transport;
    }
    transport->m_canReplace = false;
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
    m_program = findWorkerProgram();
    if (m_program.empty()) {
        reason = std::string("there is no ") + kWorker + " beside libode_mt_mpi.so, in bin/ beside its folder, or on the PATH";
        close(false);
        return false;
    }
    const NoFilesForChildren noFiles;
    for (unsigned i = 0; i < wanted; ++i) {
        MPI_Comm worker = MPI_COMM_NULL;
        const int result = spawnOne(m_program, worker);
        if (result != MPI_SUCCESS || worker == MPI_COMM_NULL) {
            reason = m_program + " cannot be started: " + textOf(result);
            break;
        }
        m_links.push_back({worker, 0});
        m_probed.push_back(worker);
    }
    return !m_links.empty();
}

std::unique_ptr<dxMpiTransport> dxMpiTransport::openWorker(std::string &reason) {
    std::unique_ptr<dxMpiTransport> transport(new dxMpiTransport);
    if (doesJobSurvive()) listenElsewhere();
    if (!transport->initialise(MPI_THREAD_SERIALIZED, reason)) return nullptr;
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
        if (MPI_Test(&sending->request, &isComplete, MPI_STATUS_IGNORE) == MPI_SUCCESS && !isComplete) {
            ++sending;
        } else {
            m_spare.giveBack(std::move(sending->bytes));
            sending = m_sending.erase(sending);
        }
    }
}

bool dxMpiTransport::send(unsigned link, const void *message, std::size_t bytes) {
    forgetSent();
    if (bytes > INT_MAX || m_links[link].communicator == MPI_COMM_NULL) return false;
    const auto *const from = static_cast<const std::byte *>(message);
    dxRemoteBytes copy = m_spare.take();
    copy.assign(from, from + bytes);
    m_sending.push_back({std::move(copy), MPI_REQUEST_NULL});
    Sending &sending = m_sending.back();
    const Link &to = m_links[link];
    const int count = static_cast<int>(bytes);
    if (MPI_Isend(sending.bytes.data(), count, MPI_BYTE, to.rank, kTag, to.communicator, &sending.request) == MPI_SUCCESS) return true;
    m_sending.pop_back();
    return false;
}

// Open MPI first looks for the message, and then receives what has arrived. The next call finds that, and must not come after a pause.
std::size_t dxMpiTransport::waiting(unsigned &link) {
    if (!m_sending.empty()) forgetSent();
    std::size_t bytes = 0;
    for (int looks = 0; looks < 2 && bytes == 0; ++looks) bytes = probe(link);
    return bytes;
}

std::size_t dxMpiTransport::probe(unsigned &link) {
    const unsigned count = static_cast<unsigned>(m_probed.size());
    for (unsigned i = 0; i < count; ++i) {
        const unsigned one = (m_next + i) % count;
        if (m_probed[one] == MPI_COMM_NULL) continue;
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

// The lost worker's communicator is left as it is: without that process nothing can be agreed upon.
void dxMpiTransport::replace(unsigned link) {
    if (m_start) return;
    m_hasReplaced = true;
    auto start = std::make_shared<Start>();
    start->link = link;
    m_links[link].communicator = m_probed[link] = MPI_COMM_NULL;
    const dxBlockedSignals blocked;
    try {
        std::thread([start, program = m_program] {
            spawnOne(program, start->worker);
            start->hasEnded = true;
        }).detach();
        m_start = std::move(start);
    } catch (const std::exception &) {  // no thread: the replacement has failed
    }
}

dxRemoteTransport::Replacement dxMpiTransport::replacement() {
    constexpr std::chrono::seconds kMaxStart{150};  // Open MPI itself gives up after 60
    if (!m_start) return Replacement::Failed;
    if (!m_start->hasEnded) {
        if (std::chrono::steady_clock::now() - m_start->begin < kMaxStart) return Replacement::Expected;
        m_canReplace = false;
        m_start.reset();
        return Replacement::Failed;
    }
    const std::shared_ptr<Start> start = std::move(m_start);
    if (start->worker == MPI_COMM_NULL) return Replacement::Failed;
    m_links[start->link].communicator = m_probed[start->link] = start->worker;
    return Replacement::Here;
}

// MPI_Finalize first deletes what is attached to MPI_COMM_SELF (MPI 3.1, 8.7.1).
void dxMpiTransport::setEnd(void (*end)()) {
    if (m_isOwn) return;
    int key = MPI_KEYVAL_INVALID;
    const auto atEnd = [](MPI_Comm, int, void *attached, void *) {
        reinterpret_cast<void (*)()>(attached)();
        return MPI_SUCCESS;
    };
    if (MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, atEnd, &key, nullptr) == MPI_SUCCESS)
        MPI_Comm_set_attr(MPI_COMM_SELF, key, reinterpret_cast<void *>(end));
}

// Without the others MPI_Finalize would wait for them for ever.
void dxMpiTransport::close(bool isOrderly) {
    for (int attempt = 0; attempt < 100 && !m_sending.empty(); ++attempt) {
        forgetSent();
        if (!m_sending.empty()) usleep(1000);
    }
    if (m_hasReplaced) isOrderly = false;
    if (!isOrderly && m_links.empty()) isOrderly = m_isOwn;  // nothing has been agreed upon with anybody
    if (!isOrderly) {
        new std::list<Sending>(std::move(m_sending));  // MPI may read them until the process ends
        return;
    }
    if (m_isSpawned)
        for (Link &link : m_links) MPI_Comm_disconnect(&link.communicator);
    if (m_isOwn) MPI_Finalize();
}
