/* SPDX-License-Identifier: BSD-3-Clause */
/* LAMMPS data files of atom style sphere ("Atoms # sphere": id type diameter density x y z [ix iy iz];
 * Velocities: id v omega). */
#ifndef SCREE_FORMATS_LAMMPS_DATA_H
#define SCREE_FORMATS_LAMMPS_DATA_H

#include "base/error.h"
#include "data/formats/rows.h"

/* Reads a whole file (one rank, or every rank alike): box, id, type - 1 as material, radius, mass, position,
 * images and velocities if given. Only a cuboid box and style sphere are accepted; errors name file and line.
 * rows_free releases. */
bool lammps_data_read(const char *path, struct rows *rows, struct error *error);

/* Writes all rows (position, radius and the box are required; mass 0 or absent: density 1; id absent: 1, 2,
 * ...; material absent: type 1). The file appears whole, by a temporary name. */
bool lammps_data_write(const char *path, const struct rows *rows, struct error *error);

#endif
