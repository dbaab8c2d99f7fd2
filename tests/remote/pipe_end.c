/* The program's files, and the processes that are started for remote workers. Status 0: as they should be.
 *
 * odemt_pipe_end kept    a pipe that the program has opened before dInitODE ends when the program closes it: within ten seconds
 * odemt_pipe_end closed  another thread closes files while MPI begins, whose numbers MPI's own files get: there are workers (by the log) all the same
 */
#include <ode/ode.h>

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <string.h>
#include <unistd.h>

enum {
    kFiles = 200,
    kAtOnce = 4, /* files that stay open only when MPI has begun: whoever reads one before has no more than that */
};

static int pipeEnds(void) {
    int ends[2];
    if (pipe(ends) != 0) return 0;
    dInitODE2(0);
    close(ends[1]);
    struct pollfd reading = {ends[0], POLLIN, 0};
    char byte = 0;
    const int hasEnded = poll(&reading, 1, 10000) == 1 && read(ends[0], &byte, 1) == 0;
    dCloseODE();
    return hasEnded;
}

/* files: the numbers of kFiles, the last of which is the highest. */
static void *closeThem(void *files) {
    const int *const numbers = files;
    while (fcntl(numbers[kFiles - 1] + kAtOnce, F_GETFD) < 0) usleep(20);
    for (int i = 0; i < kFiles; ++i) close(numbers[i]);
    return NULL;
}

static int beginsWhileFilesAreClosed(void) {
    int files[kFiles];
    for (int i = 0; i < kFiles; ++i)
        if ((files[i] = open("/dev/null", O_RDONLY)) < 0) return 0;
    pthread_t closer;
    if (pthread_create(&closer, NULL, closeThem, files) != 0) return 0;
    dInitODE2(0);
    pthread_join(closer, NULL);
    dCloseODE();
    return 1;
}

int main(int count, char **arguments) {
    if (count != 2) return 2;
    return (strcmp(arguments[1], "closed") == 0 ? beginsWhileFilesAreClosed() : pipeEnds()) ? 0 : 1;
}
