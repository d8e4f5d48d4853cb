#include "formats/h5_watch.h"

#include "comm/writes.h"
#include "files/file.h"
#include "formats/output.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Seconds from the failure to the end, and those that each further rank waits longer, so that one speaks. */
enum { PATIENCE = 10, STEP = 2, STEPS_MAX = 20 };

static struct {
    int rank;
    char path[FILE_PATH_MAX];
    char message[FILE_PATH_MAX + 512];
    size_t length; /* of the message; 0: no failure yet */
} watch;

static void on_alarm(int signal) {
    (void)signal;
    ssize_t written = write(STDERR_FILENO, watch.message, watch.length);
    (void)written;
    _exit(1);
}

static void arm(void) {
    if (watch.length > 0)
        return;
    int place = watch.rank < STEPS_MAX ? watch.rank : STEPS_MAX;
    struct error room = {0};
    int64_t present = file_size(watch.path);
    bool full = !file_check_room(watch.path, present > 0 ? (uint64_t)present : 0, 1 << 16, &room);
    snprintf(watch.message, sizeof watch.message, "scree: %s: cannot be written on rank %d%s%s\n", watch.path,
             watch.rank, full ? "; " : "", room.text);
    watch.length = strlen(watch.message);
    alarm((unsigned)(PATIENCE + STEP * place));
}

void h5_watch_begin(const struct comm *comm, const char *path) {
    struct sigaction action = {.sa_handler = on_alarm};
    sigemptyset(&action.sa_mask);
    sigaction(SIGALRM, &action, NULL);
    snprintf(watch.path, sizeof watch.path, "%s", path);
    watch.rank = comm->rank;
    watch.length = 0;
    writes_watch(arm);
}

void h5_watch_end(void) {
    writes_watch(NULL);
    alarm(0);
}
