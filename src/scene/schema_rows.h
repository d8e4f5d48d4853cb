/* For the files that hold schema rows: where a member lies. */
#ifndef SCREE_SCENE_SCHEMA_ROWS_H
#define SCREE_SCENE_SCHEMA_ROWS_H

#include "scene/schema.h"

#define AT(type, member) .offset = offsetof(type, member), .size = sizeof(((type *)0)->member)

/* An array member and the member that counts its entries. */
#define ARRAY_AT(type, member, counter)                                                                      \
    .offset = offsetof(type, member), .size = sizeof(((type *)0)->member[0]),                                \
    .max = sizeof(((type *)0)->member) / sizeof(((type *)0)->member[0]),                                     \
    .count_offset = offsetof(type, counter)

#define TABLE(array)                                                                                         \
    { array, sizeof(array) / sizeof(array[0]) }

#endif
