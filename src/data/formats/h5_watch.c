/* SPDX-License-Identifier: BSD-3-Clause */
/* Ends the job if the ranks are at different calls inside HDF5. Read h5_watch.h first. */
#include "data/formats/h5_watch.h"

#include "kernel/comm/files.h"
#include "base/file.h"
#include "data/formats/output.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* PATIENCE: seconds from the failure to the end. STEP: seconds that each further rank waits longer, so that
 * only one rank prints the message. Opening on all ranks together may take OPENING seconds and OPENING_TIMES
 * the time of a single opening. */
enum { PATIENCE = 10, STEP = 2, STEPS_MAX = 20, OPENING = 20, OPENING_TIMES = 10, HANDLES_MAX = 4096 };

static const char program[] = "scree: ";

static struct {
    int rank;
    bool opening, asked; /* HDF5 is opening the file; this rank has the file open, and reports last */
    bool told;           /* that the watch does not work here */
    unsigned long files; /* opened before (files_opened) */
    char path[FILE_PATH_MAX];
    char message[FILE_PATH_MAX + 512];
    size_t length; /* of the message; 0: no failure yet */
} watch;

static _Noreturn void end(void) {
    ssize_t written = write(STDERR_FILENO, watch.message, watch.length);
    (void)written;
    _exit(1);
}

/* Seconds that this rank waits, so that the ranks before it report first. */
static unsigned turn(void) {
    return (unsigned)(STEP * (watch.rank < STEPS_MAX ? watch.rank : STEPS_MAX));
}

static void describe(const char *what) {
    struct error room = {0};
    int64_t present = file_size(watch.path);
    bool writes = strcmp(what, "opened") != 0 && strcmp(what, "read") != 0;
    bool full = writes && !file_check_room(watch.path, present > 0 ? (uint64_t)present : 0, 1 << 16, &room);
    snprintf(watch.message, sizeof watch.message, "%s%s: cannot be %s on rank %d%s%s\n", program, watch.path,
             what, watch.rank, full ? "; " : "", room.text);
    watch.length = strlen(watch.message);
}

/* True if this process has the file open. */
static bool is_open(void) {
    struct stat file, other;
    if (stat(watch.path, &file) != 0)
        return false;
    for (int handle = 0; handle < HANDLES_MAX; handle++)
        if (fstat(handle, &other) == 0 && other.st_dev == file.st_dev && other.st_ino == file.st_ino)
            return true;
    return false;
}

static void on_alarm(int signal) {
    (void)signal;
    if (watch.opening && !watch.asked && is_open()) {
        watch.asked = true;
        alarm(PATIENCE);
        return;
    }
    end();
}

static void arm(const char *what) {
    if (watch.length > 0 && !watch.opening)
        return;
    watch.opening = false;
    describe(what);
    if (strcmp(what, "read") == 0) { /* HDF5 1.10 crashes after some failed reads: do not return */
        sleep(turn());
        end();
    }
    alarm(PATIENCE + turn());
}

void h5_watch_begin(const struct comm *comm, const char *path) {
    struct sigaction action = {.sa_handler = on_alarm};
    sigemptyset(&action.sa_mask);
    sigaction(SIGALRM, &action, NULL);
    snprintf(watch.path, sizeof watch.path, "%s", path);
    watch.rank = comm->rank;
    watch.length = 0;
    watch.opening = false;
    files_watch(arm);
}

void h5_watch_opening(double alone) {
    describe("opened");
    watch.opening = true;
    watch.files = files_opened();
    watch.asked = false;
    alarm(OPENING + (unsigned)(OPENING_TIMES * alone) + turn());
}

void h5_watch_opened(void) {
    if (!watch.opening)
        return;
    alarm(0);
    watch.opening = false;
    watch.length = 0;
    if (files_opened() == watch.files && !watch.told && watch.rank == 0)
        fprintf(stderr,
                "%snote: MPI was loaded before scree, so a write to %s that fails on one rank alone may "
                "leave all "
                "ranks waiting; load, or link, scree first\n",
                program, watch.path);
    watch.told = true;
}

void h5_watch_end(void) {
    files_watch(NULL);
    alarm(0);
    watch.length = 0;
    watch.opening = false;
}

bool h5_watch_take(struct error *error) {
    size_t lead = strlen(program);
    if (watch.length == 0)
        return true;
    return error_set(error, ERROR_SYSTEM, "%.*s", (int)(watch.length - lead - 1), watch.message + lead);
}
