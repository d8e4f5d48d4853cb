/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers the requests of the page of a live view. Read server.h first. */
#include "config.h"
#include "front/view/server.h"

#ifdef HAVE_MICROHTTPD

#include "base/memory.h"
#include "base/file.h"
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <microhttpd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    TOKEN_BYTES = 16,
    TOKEN_LENGTH = 2 * TOKEN_BYTES,
    CONNECTIONS_MAX = 256,
    MEMORY_MAX = 16384,
    IDLE_SECONDS = 30,
    ASKING_SECONDS = 2, /* of a connection that has shown no token yet */
    TABLE_MAX = 262144
};

struct server {
    struct MHD_Daemon *daemon;
    struct board *board; /* borrowed */
    char token[TOKEN_LENGTH + 1], address[128], page[FILE_PATH_MAX], table[FILE_PATH_MAX];
};

/* The files of the page. */
static const struct served {
    const char *name, *file, *type;
} served[] = {
    {"", "view.html", "text/html; charset=utf-8"},
    {"view.js", "view.js", "text/javascript; charset=utf-8"},
    {"view.css", "view.css", "text/css; charset=utf-8"},
    {"three.module.min.js", "three.module.min.js", "text/javascript; charset=utf-8"},
    {"OrbitControls.js", "OrbitControls.js", "text/javascript; charset=utf-8"},
    {"uPlot.iife.min.js", "uPlot.iife.min.js", "text/javascript; charset=utf-8"},
    {"uPlot.min.css", "uPlot.min.css", "text/css; charset=utf-8"},
};

static enum MHD_Result send_it(struct MHD_Connection *connection, unsigned status, const char *type,
                               struct MHD_Response *response) {
    static const char *const heads[][2] = {
        {"Cache-Control", "no-store"},
        {"Content-Security-Policy", "default-src 'none'; script-src 'self'; style-src 'self'; "
                                    "connect-src 'self'; img-src 'self' data:; frame-ancestors 'none'"},
        {"Referrer-Policy", "no-referrer"},
        {"X-Content-Type-Options", "nosniff"}};
    if (response == NULL)
        return MHD_NO;
    for (size_t k = 0; k < sizeof heads / sizeof heads[0]; k++)
        MHD_add_response_header(response, heads[k][0], heads[k][1]);
    MHD_add_response_header(response, "Content-Type", type);
    enum MHD_Result result = MHD_queue_response(connection, status, response);
    MHD_destroy_response(response);
    return result;
}

static enum MHD_Result send_status(struct MHD_Connection *connection, unsigned status) {
    return send_it(connection, status, "text/plain",
                   MHD_create_response_from_buffer(0, "", MHD_RESPMEM_PERSISTENT));
}

/* Sends malloc'ed text; 204 without. */
static enum MHD_Result send_text(struct MHD_Connection *connection, const char *type, char *text,
                                 size_t bytes) {
    if (text == NULL)
        return send_status(connection, MHD_HTTP_NO_CONTENT);
    return send_it(connection, MHD_HTTP_OK, type,
                   MHD_create_response_from_buffer(bytes, text, MHD_RESPMEM_MUST_FREE));
}

static enum MHD_Result send_file(struct MHD_Connection *connection, const struct server *server,
                                 const struct served *what) {
    char path[FILE_PATH_MAX + 64];
    struct stat found;
    snprintf(path, sizeof path, "%s/%s", server->page, what->file);
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0 || fstat(file, &found) != 0) {
        if (file >= 0)
            close(file);
        return send_status(connection, MHD_HTTP_NOT_FOUND);
    }
    return send_it(connection, MHD_HTTP_OK, what->type,
                   MHD_create_response_from_fd((uint64_t)found.st_size, file));
}

/* A whole number of the address, else `otherwise`. */
static long long argument(struct MHD_Connection *connection, const char *name, long long otherwise) {
    const char *text = MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, name);
    char *end;
    long long value = text ? strtoll(text, &end, 10) : otherwise;
    return text == NULL || (end > text && *end == '\0') ? value : otherwise;
}

static enum MHD_Result send_frame(struct MHD_Connection *connection, const struct server *server) {
    size_t bytes;
    char text[32];
    long long after = argument(connection, "after", 0), field = argument(connection, "field", -1);
    uint64_t number = after > 0 ? (uint64_t)after : 0;
    board_want(server->board, field > 1000 ? -1 : (int)field);
    char *frame = board_frame(server->board, &number, &bytes);
    if (frame == NULL)
        return send_status(connection, MHD_HTTP_NO_CONTENT);
    struct MHD_Response *response = MHD_create_response_from_buffer(bytes, frame, MHD_RESPMEM_MUST_FREE);
    snprintf(text, sizeof text, "%llu", (unsigned long long)number);
    if (response)
        MHD_add_response_header(response, "X-Frame", text);
    return send_it(connection, MHD_HTTP_OK, "application/octet-stream", response);
}

static enum MHD_Result send_table(struct MHD_Connection *connection, const struct server *server) {
    long long from = argument(connection, "from", 0);
    FILE *file = from >= 0 ? fopen(server->table, "r") : NULL;
    char *text = file && fseek(file, (long)from, SEEK_SET) == 0 ? malloc(TABLE_MAX) : NULL;
    size_t bytes = text ? fread(text, 1, TABLE_MAX, file) : 0;
    if (file)
        fclose(file);
    if (bytes == 0) {
        free(text);
        text = NULL;
    }
    return send_text(connection, "text/csv; charset=utf-8", text, bytes);
}

static enum MHD_Result answer_get(struct MHD_Connection *connection, const struct server *server,
                                  const char *name) {
    size_t bytes;
    if (strcmp(name, "frame") == 0)
        return send_frame(connection, server);
    if (strcmp(name, "observables") == 0)
        return send_table(connection, server);
    if (strcmp(name, "about") == 0) {
        char *about = board_about(server->board, &bytes);
        return send_text(connection, "application/json", about, bytes);
    }
    for (size_t k = 0; k < sizeof served / sizeof served[0]; k++)
        if (strcmp(served[k].name, name) == 0)
            return send_file(connection, server, &served[k]);
    return send_status(connection, MHD_HTTP_NOT_FOUND);
}

static enum MHD_Result answer_post(struct MHD_Connection *connection, const struct server *server,
                                   const char *name) {
    long long count = argument(connection, "count", 1);
    if (strcmp(name, "pause") == 0)
        board_pause(server->board);
    else if (strcmp(name, "go") == 0)
        board_go(server->board);
    else if (strcmp(name, "step") == 0 && count >= 1 && count <= 1000000000)
        board_step(server->board, (int)count);
    else
        return send_status(connection, MHD_HTTP_NOT_FOUND);
    return send_status(connection, MHD_HTTP_NO_CONTENT);
}

/* True for a name of this machine, with a port or without. */
static bool host_suits(const char *host) {
    static const char *const names[] = {"127.0.0.1", "localhost", "[::1]"};
    for (size_t k = 0; host && k < sizeof names / sizeof names[0]; k++) {
        size_t length = strlen(names[k]);
        if (strncmp(host, names[k], length) == 0 && (host[length] == '\0' || host[length] == ':'))
            return true;
    }
    return false;
}

/* The part of the address behind the token; NULL: no token, or a wrong one. Takes the same time for each wrong token. */
static const char *behind_token(const struct server *server, const char *url) {
    unsigned wrong = 0;
    if (strlen(url) < TOKEN_LENGTH + 2)
        return NULL;
    for (size_t k = 0; k < TOKEN_LENGTH; k++)
        wrong |= (unsigned char)url[k + 1] ^ (unsigned char)server->token[k];
    wrong |= (unsigned)(url[0] != '/') | (unsigned)(url[TOKEN_LENGTH + 1] != '/');
    return wrong ? NULL : url + TOKEN_LENGTH + 2;
}

static enum MHD_Result answer(void *context, struct MHD_Connection *connection, const char *url,
                              const char *method, const char *version, const char *body, size_t *body_bytes,
                              void **request) {
    static char begun;
    const struct server *server = context;
    (void)version;
    (void)body;
    if (*body_bytes > 0)
        return MHD_NO;
    if (*request == NULL) { /* the heads are there; the answer may come when the request is whole */
        *request = &begun;
        return MHD_YES;
    }
    const char *name = behind_token(server, url);
    if (name == NULL ||
        !host_suits(MHD_lookup_connection_value(connection, MHD_HEADER_KIND, MHD_HTTP_HEADER_HOST)))
        return send_status(connection, MHD_HTTP_FORBIDDEN);
    MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, (unsigned)IDLE_SECONDS);
    if (strcmp(method, "GET") == 0)
        return answer_get(connection, server, name);
    if (strcmp(method, "POST") == 0)
        return answer_post(connection, server, name);
    return send_status(connection, MHD_HTTP_METHOD_NOT_ALLOWED);
}

static bool token_draw(struct server *server, struct error *error) {
    unsigned char bytes[TOKEN_BYTES];
    if (getrandom(bytes, sizeof bytes, 0) != (ssize_t)sizeof bytes)
        return error_set_errno(error, "live view: no random numbers for its token");
    for (int k = 0; k < TOKEN_BYTES; k++)
        snprintf(server->token + 2 * k, 3, "%02x", bytes[k]);
    return true;
}

bool server_start(struct server **out, struct board *board, const struct server_options *options,
                  struct error *error) {
    struct server *server = memory_allocate_zero(1, sizeof *server, "live view");
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons((uint16_t)options->port)};
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    server->board = board;
    *out = server;
    snprintf(server->page, sizeof server->page, "%s", options->page);
    if (!file_join(server->table, options->directory, "observables.csv", error) || !token_draw(server, error))
        return false;
    errno = 0;
    server->daemon =
        MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD, (uint16_t)options->port, NULL, NULL, answer, server,
                         MHD_OPTION_SOCK_ADDR, &place, MHD_OPTION_CONNECTION_LIMIT, (unsigned)CONNECTIONS_MAX,
                         MHD_OPTION_CONNECTION_MEMORY_LIMIT, (size_t)MEMORY_MAX,
                         MHD_OPTION_CONNECTION_TIMEOUT, (unsigned)ASKING_SECONDS, MHD_OPTION_END);
    if (server->daemon == NULL)
        return error_set(error, ERROR_USER, "command line: --view: port %d of 127.0.0.1 cannot be used: %s",
                         options->port, errno ? strerror(errno) : "no reason is known");
    const union MHD_DaemonInfo *info = MHD_get_daemon_info(server->daemon, MHD_DAEMON_INFO_BIND_PORT);
    snprintf(server->address, sizeof server->address, "http://127.0.0.1:%d/%s/",
             info ? info->port : options->port, server->token);
    return true;
}

void server_stop(struct server **server) {
    if (*server == NULL)
        return;
    if ((*server)->daemon)
        MHD_stop_daemon((*server)->daemon);
    memory_free(*server);
    *server = NULL;
}

const char *server_address(const struct server *server) {
    return server->address;
}

#else

bool server_start(struct server **server, struct board *board, const struct server_options *options,
                  struct error *error) {
    (void)board;
    (void)options;
    *server = NULL;
    return error_set(error, ERROR_USER,
                     "command line: --view: this program was built without libmicrohttpd (Debian: "
                     "libmicrohttpd-dev), and has no live view");
}

void server_stop(struct server **server) {
    *server = NULL;
}

const char *server_address(const struct server *server) {
    (void)server;
    return "";
}

#endif
