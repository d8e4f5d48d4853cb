/* SPDX-License-Identifier: BSD-3-Clause */
/* Frames of the walls for ParaView and other programs: DIR/walls-STEP.vtp, a file of VTK's XML format a frame, with raw
 * arrays; DIR/walls.pvd, the list of these files with their times; DIR/walls.xdmf, which points into the same files. Both
 * lists stay: ParaView's own is the first, which a resume reads, and the second is for programs that read XDMF, the format
 * of the particles' list. The triangles are those of wall_surface_make. Rank 0 writes. */
#ifndef SCREE_FORMATS_WALL_FRAMES_H
#define SCREE_FORMATS_WALL_FRAMES_H

#include "data/formats/output.h"

struct wall_frames;

/* Begins a new list of frames, or on a resume (`resume_step` >= 0) goes on with the list up to that step. Removes other
 * frames. Borrows comm. Collective. */
bool wall_frames_open(struct wall_frames **frames, const struct comm *comm, const char *directory,
                      int64_t resume_step, struct error *error);

/* Writes a frame, if there are walls, and both lists. Each file appears whole or not at all. Collective. */
bool wall_frames_write(struct wall_frames *frames, const struct output_view *view, struct error *error);

void wall_frames_close(struct wall_frames **frames);

/* Removes the frames of later steps than `step`; -1: all. One rank. */
void wall_frames_discard(const char *directory, int64_t step);

/* Bytes of a frame of so many triangles. */
double wall_frames_bytes(double triangles);

#endif
