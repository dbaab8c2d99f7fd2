/* A pipe that the program has opened before dInitODE ends when the program closes it, whatever processes have been started for remote workers:
 * status 0. Otherwise 1, after ten seconds. */
#include <ode/ode.h>

#include <poll.h>
#include <unistd.h>

int main(void) {
    int ends[2];
    if (pipe(ends) != 0) return 2;
    dInitODE2(0);
    close(ends[1]);
    struct pollfd reading = {ends[0], POLLIN, 0};
    char byte = 0;
    const int hasEnded = poll(&reading, 1, 10000) == 1 && read(ends[0], &byte, 1) == 0;
    dCloseODE();
    return hasEnded ? 0 : 1;
}
