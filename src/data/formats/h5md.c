/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of an H5MD writer: open, flush, close. Read h5md_file.h first. */
#include "data/formats/h5md.h"
#include "data/formats/h5md_file.h"
#include "data/formats/h5md_parts.h"

#include "base/memory.h"
#include "base/file.h"

#include <stdio.h>
#include <string.h>

bool h5md_suits(const struct comm *comm, const char *path, bool varying, struct error *error) {
    struct h5md h5md = {.varying = varying};
    struct h5 h5;
    if (!h5_open(&h5, path, comm, false, error))
        return false;
    bool good = h5md_check_varying(&h5md, &h5, error);
    return h5_close(&h5, error) && good;
}

bool h5md_open(struct h5md **h5md, const struct comm *comm, const char *path, const struct h5md_head *head,
               int64_t resume_step, struct error *error) {
    *h5md = NULL;
    size_t length = strlen(path);
    if (length < 4 || length + 3 > FILE_PATH_MAX || strcmp(path + length - 3, ".h5") != 0)
        return error_set(error, ERROR_USER, "%.200s: the name of an H5MD file must end in .h5", path);
    struct h5md *made = memory_allocate_zero(1, sizeof *made, "H5MD writer");
    made->comm = comm;
    made->dimensionless = head->dimensionless;
    made->varying = head->varying;
    made->xdmf = head->xdmf;
    made->single = head->single;
    made->deflate = head->deflate;
    made->seed = head->seed;
    snprintf(made->path, sizeof made->path, "%s", path);
    snprintf(made->xdmf_path, sizeof made->xdmf_path, "%.*s.xdmf", (int)(length - 3), path);
    made->lineage = head->lineage;
    made->shapes = head->shapes;
    *h5md = made;
    int64_t present = comm->rank == 0 && resume_step >= 0 && file_size(path) >= 0;
    comm_max_int(comm, &present, 1);
    if (present && !h5md_resume(made, resume_step, error)) {
        struct error ignored = {0};
        made->kept = 0;
        made->xdmf = false;
        h5md_close(h5md, &ignored);
        return false;
    }
    return true;
}

/* Writes the observables that still wait, if the file exists. */
bool h5md_flush(struct h5md *h5md, struct error *error) {
    if (h5md->kept == 0 || !h5md->made)
        return true;
    struct h5 h5;
    if (!h5md_reserve(h5md, 1 << 16, error) || !h5_open(&h5, h5md->path, h5md->comm, true, error))
        return false;
    h5md_write_observables(h5md, &h5, error);
    return h5_close(&h5, error);
}

bool h5md_close(struct h5md **h5md, struct error *error) {
    struct h5md *h = *h5md;
    if (!h)
        return true;
    bool good = h5md_flush(h, error) && h5md_update_xdmf(h, true, error);
    memory_free(h->frame);
    memory_free(h->kept_step);
    memory_free(h->kept_time);
    memory_free(h->kept_value);
    memory_free(h);
    *h5md = NULL;
    return good;
}

bool h5md_write_xdmf(const char *path, const char *xdmf_path, const struct comm *comm, struct error *error) {
    struct h5md_head head = {.xdmf = true};
    struct h5md *h5md = NULL;
    struct h5 h5;
    if (!h5md_open(&h5md, comm, path, &head, -1, error))
        return false;
    snprintf(h5md->xdmf_path, sizeof h5md->xdmf_path, "%s", xdmf_path);
    bool good = h5_open(&h5, path, comm, false, error);
    if (good) {
        good = h5md_recall(h5md, &h5, error);
        if (good && h5md->frames == 0)
            good = error_set(error, ERROR_USER, "%s: holds no frames that scree wrote", path);
        good = h5_close(&h5, error) && good;
    }
    struct error ignored = {0};
    return h5md_close(&h5md, good ? error : &ignored) && good;
}
