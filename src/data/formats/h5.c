/* SPDX-License-Identifier: BSD-3-Clause */
/* Opens, closes and makes HDF5 files, groups and attributes, each call checked. Read h5.h first. */
#include "data/formats/h5.h"

#include "base/memory.h"
#include "base/timer.h"
#include "base/file.h"
#include "data/formats/h5_watch.h"
#include "data/formats/output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The message of HDF5: the innermost record of the error stack. */
struct said {
    char text[512];
};

static herr_t keep_first(unsigned n, const H5E_error2_t *record, void *context) {
    struct said *said = context;
    if (n == 0 && record->desc)
        snprintf(said->text, sizeof said->text, "%s", record->desc);
    return 0;
}

bool h5_fail(const struct h5 *h5, enum error_kind kind, const char *object, const char *what,
             struct error *error) {
    struct said said = {"no further text"};
    if (kind == ERROR_USER && h5->comm && !h5_watch_take(error)) {
        H5Eclear2(H5E_DEFAULT);
        return false;
    }
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &said);
    H5Eclear2(H5E_DEFAULT);
    for (char *c = said.text; *c; c++)
        if (*c == '\n')
            *c = ' ';
    /* MPI does not pass errno on: check whether the disk is full */
    struct error room = {0};
    int64_t present = file_size(h5->path);
    bool full = kind == ERROR_SYSTEM &&
                !file_check_room(h5->path, present > 0 ? (uint64_t)present : 0, 1 << 16, &room);
    return error_set(error, kind, "%s%s%s: %s (HDF5: %s)%s%s", h5->path, object[0] ? ": " : "", object, what,
                     said.text, full ? "; " : "", room.text);
}

static bool begin(struct h5 *h5, const char *path, const struct comm *comm, struct error *error) {
    *h5 = (struct h5){.file = -1, .transfer = H5P_DEFAULT, .comm = comm, .folder = -1};
    if (strlen(path) >= sizeof h5->path)
        return error_set(error, ERROR_USER, "%.100s...: the path is longer than %d characters", path,
                         FILE_PATH_MAX - 1);
    snprintf(h5->path, sizeof h5->path, "%s", path);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    if (!comm)
        return true;
    h5_watch_begin(comm, path);
    h5->transfer = H5Pcreate(H5P_DATASET_XFER);
    if (h5->transfer < 0 || H5Pset_dxpl_mpio(h5->transfer, H5FD_MPIO_COLLECTIVE) < 0)
        return h5_fail(h5, ERROR_SYSTEM, "", "collective transfer cannot be set", error);
    return true;
}

/* The list of access properties; < 0 on failure. Format version 1.8: checksums on metadata, and no mark of an
 * open file, which would prevent reading after a crash. */
static hid_t access_list(const struct comm *comm) {
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    bool good = access >= 0 && H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST) >= 0;
    if (good && comm)
        good = H5Pset_fapl_mpio(access, comm->handle, MPI_INFO_NULL) >= 0 &&
               H5Pset_all_coll_metadata_ops(access, true) >= 0 &&
               H5Pset_coll_metadata_write(access, true) >= 0;
    if (!good && access >= 0) {
        H5Pclose(access);
        return -1;
    }
    return access;
}

bool h5_agree(const struct h5 *h5, struct error *error) {
    return h5->comm ? comm_agree(h5->comm, error) : error->kind == ERROR_NONE;
}

/* As h5_agree; in addition, a failure that the watch has seen on one rank becomes an error of all ranks. */
static bool agree_watch(const struct h5 *h5, struct error *error) {
    if (h5->comm)
        h5_watch_take(error);
    return h5_agree(h5, error);
}

/* Opens a file and closes it. */
static void try_open(const struct h5 *h5, bool write, struct error *error) {
    const char *waits = file_waits(h5->path);
    if (waits) {
        error_set(error, ERROR_USER, "%s: %s", h5->path, waits);
        return;
    }
    int handle = open(h5->path, (write ? O_RDWR : O_RDONLY) | O_CLOEXEC);
    if (handle >= 0)
        close(handle);
    else if (file_is_missing(errno))
        error_set(error, ERROR_USER, "%s: cannot be opened: %s", h5->path, strerror(errno));
    else
        error_set_errno(error, "%s: cannot be opened on rank %d", h5->path, h5->comm ? h5->comm->rank : 0);
}

/* Each rank opens the file by itself, and all ranks agree, before all open the file together: MPI would wait
 * for ever if the file cannot be opened on one rank. `name` is the name for MPI. Then the watch begins; the
 * time limit of the watch depends on the time of the single opening. */
static bool open_begin(struct h5 *h5, bool write, char name[FILE_PATH_MAX], struct error *error) {
    double began = timer_now();
    if (error->kind == ERROR_NONE && file_shorten(h5->path, name, &h5->folder, error))
        try_open(h5, write, error);
    if (!h5_agree(h5, error))
        return false;
    if (h5->comm && h5->comm->size > 1)
        h5_watch_opening(timer_now() - began);
    return true;
}

/* Called after HDF5 has opened the file or has failed. */
static bool open_end(const struct h5 *h5, struct error *error) {
    if (h5->comm)
        h5_watch_opened();
    return agree_watch(h5, error);
}

/* Makes an empty file on the first rank. */
static void make_empty(const struct h5 *h5, struct error *error) {
    if (h5->comm && h5->comm->rank > 0)
        return;
    int handle = open(h5->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (handle < 0)
        error_set_errno(error, "%s: cannot be made", h5->path);
    else
        close(handle);
}

bool h5_create(struct h5 *h5, const char *path, const struct comm *comm, uint64_t user_block,
               struct error *error) {
    char name[FILE_PATH_MAX];
    if (!begin(h5, path, comm, error))
        return false;
    hid_t list = access_list(comm), creation = H5Pcreate(H5P_FILE_CREATE);
    if (list < 0 || creation < 0 || H5Pset_userblock(creation, user_block) < 0)
        h5_fail(h5, ERROR_SYSTEM, "", "cannot be prepared", error);
    else
        make_empty(h5, error);
    if (h5_agree(h5, error) && open_begin(h5, true, name, error)) {
        h5->file = H5Fcreate(name, H5F_ACC_TRUNC, creation, list);
        if (open_end(h5, error) && h5->file < 0)
            h5_fail(h5, ERROR_SYSTEM, "", "cannot be made", error);
    }
    H5Pclose(list);
    H5Pclose(creation);
    if (!h5_agree(h5, error)) {
        h5_close(h5, error);
        return false;
    }
    return true;
}

bool h5_open(struct h5 *h5, const char *path, const struct comm *comm, bool write, struct error *error) {
    char name[FILE_PATH_MAX];
    if (!begin(h5, path, comm, error))
        return false;
    hid_t list = access_list(comm);
    if (list < 0)
        h5_fail(h5, ERROR_SYSTEM, "", "cannot be prepared", error);
    if (open_begin(h5, write, name, error)) {
        h5->file = H5Fopen(name, write ? H5F_ACC_RDWR : H5F_ACC_RDONLY, list);
        if (open_end(h5, error) && h5->file < 0)
            h5_fail(h5, ERROR_USER, "", "cannot be opened as an HDF5 file", error);
    }
    H5Pclose(list);
    if (!h5_agree(h5, error)) {
        h5_close(h5, error);
        return false;
    }
    return true;
}

bool h5_close(struct h5 *h5, struct error *error) {
    /* after a failed write the ranks are at different calls inside HDF5: further calls would not return */
    if (h5->file >= 0 && !agree_watch(h5, error) && error->kind == ERROR_SYSTEM)
        h5->file = -1;
    if (h5->file >= 0) {
        if (H5Fflush(h5->file, H5F_SCOPE_GLOBAL) < 0)
            h5_fail(h5, ERROR_SYSTEM, "", "cannot be flushed", error);
        if (H5Fclose(h5->file) < 0)
            h5_fail(h5, ERROR_SYSTEM, "", "cannot be closed", error);
        h5->file = -1;
    }
    if (h5->transfer > 0 && h5->transfer != H5P_DEFAULT)
        H5Pclose(h5->transfer);
    h5->transfer = H5P_DEFAULT;
    if (h5->folder >= 0)
        close(h5->folder);
    h5->folder = -1;
    bool good = agree_watch(h5, error);
    if (h5->comm)
        h5_watch_end();
    return good;
}

bool output_left_open(void) {
    return H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_FILE) > 0;
}

bool h5_exists(const struct h5 *h5, const char *object) {
    char part[FILE_PATH_MAX];
    size_t length = strlen(object);
    /* every part of the path is checked, as HDF5 fails if a group above is missing */
    for (size_t end = 1; end <= length; end++) {
        if (object[end] != '/' && object[end] != '\0')
            continue;
        snprintf(part, sizeof part, "%.*s", (int)end, object);
        if (strcmp(part, "/") != 0 && H5Lexists(h5->file, part, H5P_DEFAULT) <= 0) {
            H5Eclear2(H5E_DEFAULT);
            return false;
        }
    }
    return H5Oexists_by_name(h5->file, object, H5P_DEFAULT) > 0;
}

bool h5_is_group(const struct h5 *h5, const char *object) {
    if (!h5_exists(h5, object))
        return false;
    H5O_info_t info;
    bool known = H5Oget_info_by_name2(h5->file, object, &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
    return known && info.type == H5O_TYPE_GROUP;
}

static herr_t add_name(hid_t group, const char *name, const H5L_info_t *info, void *context) {
    (void)group;
    (void)info;
    struct h5_names *names = context;
    if (strlen(name) >= OUTPUT_NAME_MAX)
        return 0;
    names->name = memory_resize(names->name, names->count + 1, sizeof *names->name, "names in a group");
    snprintf(names->name[names->count++], OUTPUT_NAME_MAX, "%s", name);
    return 0;
}

bool h5_list(const struct h5 *h5, const char *group, struct h5_names *names, struct error *error) {
    *names = (struct h5_names){0};
    if (!h5_is_group(h5, group))
        return error_set(error, ERROR_USER, "%s: %s: there is no such group", h5->path, group);
    if (H5Literate_by_name(h5->file, group, H5_INDEX_NAME, H5_ITER_INC, NULL, add_name, names, H5P_DEFAULT) <
        0)
        return h5_fail(h5, ERROR_USER, group, "cannot be listed", error);
    return true;
}

bool h5_make_group(const struct h5 *h5, const char *group, struct error *error) {
    hid_t list = H5Pcreate(H5P_LINK_CREATE);
    hid_t id = -1;
    if (list >= 0 && H5Pset_create_intermediate_group(list, 1) >= 0)
        id = H5Gcreate2(h5->file, group, list, H5P_DEFAULT, H5P_DEFAULT);
    if (id < 0)
        h5_fail(h5, ERROR_SYSTEM, group, "the group cannot be made", error);
    else
        H5Gclose(id);
    H5Pclose(list);
    return id >= 0;
}

bool h5_remove(const struct h5 *h5, const char *object, struct error *error) {
    if (h5_exists(h5, object) && H5Ldelete(h5->file, object, H5P_DEFAULT) < 0)
        return h5_fail(h5, ERROR_SYSTEM, object, "cannot be taken out", error);
    return true;
}

bool h5_link(const struct h5 *h5, const char *present, const char *added, struct error *error) {
    if (H5Lcreate_hard(h5->file, present, h5->file, added, H5P_DEFAULT, H5P_DEFAULT) < 0)
        return h5_fail(h5, ERROR_SYSTEM, added, "the hard link cannot be made", error);
    return true;
}

/* Makes and writes an attribute of n values (n = 0: one, scalar). Closes `type` if it is not HDF5's own. */
static bool write_attribute(const struct h5 *h5, const char *object, const char *name, hid_t type, int n,
                            const void *value, struct error *error) {
    hsize_t size = (hsize_t)n;
    hid_t space = n > 0 ? H5Screate_simple(1, &size, NULL) : H5Screate(H5S_SCALAR);
    hid_t id = H5Acreate_by_name(h5->file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    bool good = id >= 0 && H5Awrite(id, type, value) >= 0;
    if (!good) {
        char what[OUTPUT_NAME_MAX + 40];
        snprintf(what, sizeof what, "attribute %s cannot be written", name);
        h5_fail(h5, ERROR_SYSTEM, object, what, error);
    }
    if (id >= 0)
        H5Aclose(id);
    H5Sclose(space);
    return good;
}

static hid_t text_type(size_t length) {
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, length > 0 ? length : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

bool h5_write_text(const struct h5 *h5, const char *object, const char *name, const char *text,
                   struct error *error) {
    hid_t type = text_type(strlen(text));
    bool good = write_attribute(h5, object, name, type, 0, text, error);
    H5Tclose(type);
    return good;
}

bool h5_write_free_text(const struct h5 *h5, const char *object, const char *name, const char *text,
                        struct error *error) {
    hid_t type = H5Tcopy(H5T_C_S1);
    bool good = H5Tset_size(type, H5T_VARIABLE) >= 0 && H5Tset_cset(type, H5T_CSET_UTF8) >= 0 &&
                write_attribute(h5, object, name, type, 0, &text, error);
    H5Tclose(type);
    return good;
}

bool h5_write_texts(const struct h5 *h5, const char *object, const char *name, const char *const *text, int n,
                    struct error *error) {
    size_t length = 1;
    for (int k = 0; k < n; k++)
        length = strlen(text[k]) > length ? strlen(text[k]) : length;
    char *all = memory_allocate_zero((size_t)n, length, "strings of an attribute");
    for (int k = 0; k < n; k++)
        memcpy(all + (size_t)k * length, text[k], strlen(text[k]));
    hid_t type = text_type(length);
    bool good = write_attribute(h5, object, name, type, n, all, error);
    H5Tclose(type);
    memory_free(all);
    return good;
}

bool h5_write_ints(const struct h5 *h5, const char *object, const char *name, const int *value, int n,
                   struct error *error) {
    return write_attribute(h5, object, name, H5T_NATIVE_INT, n, value, error);
}

bool h5_write_doubles(const struct h5 *h5, const char *object, const char *name, const double *value, int n,
                      struct error *error) {
    return write_attribute(h5, object, name, H5T_NATIVE_DOUBLE, n, value, error);
}

bool h5_write_reference(const struct h5 *h5, const char *object, const char *name, const char *target,
                        struct error *error) {
    hobj_ref_t reference;
    if (H5Rcreate(&reference, h5->file, target, H5R_OBJECT, -1) < 0)
        return h5_fail(h5, ERROR_SYSTEM, target, "cannot be referred to", error);
    return write_attribute(h5, object, name, H5T_STD_REF_OBJ, 0, &reference, error);
}

/* Opens an attribute that holds exactly n values of a class; < 0 if there is none. */
static hid_t open_attribute(const struct h5 *h5, const char *object, const char *name, H5T_class_t class,
                            int n) {
    hid_t id = -1;
    if (h5_exists(h5, object) && H5Aexists_by_name(h5->file, object, name, H5P_DEFAULT) > 0)
        id = H5Aopen_by_name(h5->file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    if (id < 0) {
        H5Eclear2(H5E_DEFAULT);
        return -1;
    }
    hid_t type = H5Aget_type(id), space = H5Aget_space(id);
    bool fits = H5Tget_class(type) == class && H5Sget_simple_extent_npoints(space) == n;
    H5Tclose(type);
    H5Sclose(space);
    if (fits)
        return id;
    H5Aclose(id);
    return -1;
}

/* Reads strings of fixed or varying length. */
bool h5_read_texts(const struct h5 *h5, const char *object, const char *name, char (*text)[OUTPUT_NAME_MAX],
                   int n) {
    size_t most = sizeof *text - 1;
    hid_t id = open_attribute(h5, object, name, H5T_STRING, n);
    if (id < 0)
        return false;
    hid_t type = H5Aget_type(id);
    bool varying = H5Tis_variable_str(type) > 0;
    size_t length = H5Tget_size(type);
    char *value = memory_allocate_zero((size_t)n, length, "text of an attribute");
    bool good = H5Aread(id, type, value) >= 0;
    for (int k = 0; good && k < n; k++) {
        char *one = value + (size_t)k * length;
        if (varying)
            memcpy(&one, value + (size_t)k * length, sizeof one);
        size_t used = one ? strnlen(one, varying ? most : length) : 0;
        used = used < most ? used : most;
        memcpy(text[k], one ? one : "", used);
        text[k][used] = '\0';
        if (varying)
            H5free_memory(one);
    }
    memory_free(value);
    H5Tclose(type);
    H5Aclose(id);
    return good;
}

bool h5_read_doubles(const struct h5 *h5, const char *object, const char *name, double *value, int n) {
    hid_t id = open_attribute(h5, object, name, H5T_FLOAT, n);
    bool good = id >= 0 && H5Aread(id, H5T_NATIVE_DOUBLE, value) >= 0;
    if (id >= 0)
        H5Aclose(id);
    return good;
}
