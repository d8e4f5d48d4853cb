/* SPDX-License-Identifier: BSD-3-Clause */
/* scree picture: the command line of pictures. Read front/picture/picture.h first. */
#include "front/program/commands.h"
#include "base/file.h"
#include "front/picture/picture.h"

int command_picture(const struct comm *comm, const struct command_line *line, struct error *error) {
    if (line->directory == NULL) {
        error_set(error, ERROR_USER, "command line: scree picture needs -o FILE.png, FILE.mp4 or FILE.pov");
        return error->kind;
    }
    struct picture_options options = {.colour = line->draw[DRAW_COLOUR],
                                      .range = line->draw[DRAW_RANGE],
                                      .bands = line->draw[DRAW_BANDS],
                                      .palette = line->draw[DRAW_PALETTE],
                                      .grey = line->draw[DRAW_GREY],
                                      .cut = line->draw[DRAW_CUT],
                                      .view = line->view,
                                      .size = line->draw[DRAW_SIZE],
                                      .rate = line->draw[DRAW_RATE],
                                      .frame = line->frame,
                                      .bare = line->bare};
    if (comm->size > 1)
        error_set(error, ERROR_USER, "command line: scree picture runs on one rank; it was started on %d",
                  comm->size);
    else if (!line->overwrite && file_size(line->directory) >= 0)
        error_set(error, ERROR_USER, "%s: is there already (--overwrite replaces it)", line->directory);
    else
        picture_draw(comm, line->file[0], line->directory, &options, error);
    return error->kind;
}
