/* SPDX-License-Identifier: BSD-3-Clause */
/* The server of a live view (libmicrohttpd), in a thread of its own.
 *
 * The server listens on the loopback address alone. An address begins with a token of 128 random bits, without which every request
 * gets 403, as does a request with the name of another host (so that no page of another site gets at the run by a name that points
 * at this machine). A request has a line and heads of up to 16 KiB and no body; 32 connections at a time.
 *
 *     GET  /TOKEN/                       the page, and its files
 *     GET  /TOKEN/about                  JSON (shot_about)
 *     GET  /TOKEN/frame?field=F&after=N  the newest frame (shot.h), if its number is above N, else 204
 *     GET  /TOKEN/observables?from=B     observables.csv of the run from byte B on, up to 256 KiB
 *     POST /TOKEN/pause, /TOKEN/go, /TOKEN/step?count=N */
#ifndef SCREE_VIEW_SERVER_H
#define SCREE_VIEW_SERVER_H

#include "base/error.h"
#include "front/view/board.h"

struct server;

struct server_options {
    int port;              /* 0: any that is free */
    const char *directory; /* of the run; copied */
    const char *page;      /* the folder with the files of the page; copied */
};

/* Starts the server; the board is borrowed. Errors: see view_open. server_stop waits for its thread and frees. */
bool server_start(struct server **server, struct board *board, const struct server_options *options,
                  struct error *error);
void server_stop(struct server **server);

/* "http://127.0.0.1:PORT/TOKEN/"; borrowed from the server. */
const char *server_address(const struct server *server);

#endif
