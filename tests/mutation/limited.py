"""Commands that may run away."""
import os
import resource
import signal
import subprocess
import threading


def run(command, limit=None, cpu=None, **options):
    """Whether a command succeeds within `limit` seconds, no process of it taking more than `cpu` of processor time; the end
    of what it said, "timeout" if it did not end in time; and the processor time that it took. Its children end with it."""
    def confine():
        if cpu:
            resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                               start_new_session=True, preexec_fn=confine, **options)
    watcher = _Watcher(process, limit)
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    ran_out = watcher.end() or process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return process.returncode == 0, "timeout" if ran_out else said[-2000:], usage.ru_utime + usage.ru_stime


class _Watcher:
    """Ends a process and its children when time is over."""

    def __init__(self, process, limit):
        self.process, self.is_over = process, False
        self.timer = threading.Timer(limit, self._kill) if limit else None
        if self.timer:
            self.timer.start()

    def _kill(self):
        self.is_over = True
        os.killpg(self.process.pid, signal.SIGKILL)

    def end(self):
        if self.timer:
            self.timer.cancel()
        return self.is_over
