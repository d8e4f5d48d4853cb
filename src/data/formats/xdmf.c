/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the XDMF file. Read xdmf.h first. */
#include "data/formats/xdmf.h"

#include "base/file.h"

#include <inttypes.h>
#include <string.h>

/* Writes the reference to the data of a column in frame k: a slab of the dataset. */
static void write_item(FILE *file, const struct xdmf_content *content, const struct xdmf_column *column,
                       uint64_t k) {
    const char *number = column->integer ? "Int" : "Float";
    uint64_t rows = content->frame[k].rows;
    char width[32] = "", zero[8] = "", one[8] = "";
    if (column->components > 1) {
        snprintf(width, sizeof width, " %d", column->components);
        snprintf(zero, sizeof zero, " 0");
        snprintf(one, sizeof one, " 1");
    }
    const char *lead = column->frames ? "1 " : "";
    char place[32] = "", all[32] = "";
    if (column->frames) {
        snprintf(place, sizeof place, "%" PRIu64 " ", k);
        snprintf(all, sizeof all, "%" PRIu64 " ", content->frames);
    }
    fprintf(file, "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%" PRIu64 "%s\">", rows, width);
    fprintf(file, "<DataItem Dimensions=\"3 %d\" Format=\"XML\">%s0%s %s1%s %s%" PRIu64 "%s</DataItem>",
            1 + column->frames + (column->components > 1), place, zero, lead, one, lead, rows, width);
    fprintf(file,
            "<DataItem Dimensions=\"%s%" PRIu64 "%s\" NumberType=\"%s\" Precision=\"%d\" "
            "Format=\"HDF\">%s:%s</DataItem></DataItem>\n",
            all, content->rows, width, number, column->bytes, content->h5, column->dataset);
}

static void write_grid(FILE *file, const struct xdmf_content *content, uint64_t k) {
    const struct xdmf_frame *frame = &content->frame[k];
    fprintf(file,
            "<Grid Name=\"step %" PRIu64 "\" GridType=\"Uniform\"><Time Value=\"%.17g\"/>\n"
            "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"%" PRIu64
            "\" NodesPerElement=\"1\"/>\n",
            frame->step, frame->time, frame->rows);
    for (int c = 0; c < content->columns; c++) {
        const struct xdmf_column *column = &content->column[c];
        if (strcmp(column->name, "position") == 0) {
            fprintf(file, "<Geometry GeometryType=\"%s\">", column->components == 2 ? "XY" : "XYZ");
            write_item(file, content, column, k);
            fprintf(file, "</Geometry>\n");
            continue;
        }
        const char *type = column->components == 1 ? "Scalar" : column->components == 3 ? "Vector" : "Matrix";
        fprintf(file, "<Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">", column->name, type);
        write_item(file, content, column, k);
        fprintf(file, "</Attribute>\n");
    }
    fprintf(file, "</Grid>\n");
}

bool xdmf_write(const char *path, const struct xdmf_content *content, struct error *error) {
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    fprintf(file.stream, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
                         "<Grid Name=\"particles\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
    for (uint64_t k = 0; k < content->frames; k++)
        if (content->frame[k].rows > 0)
            write_grid(file.stream, content, k);
    fprintf(file.stream, "</Grid>\n</Domain></Xdmf>\n");
    return file_new_close(&file, error);
}
