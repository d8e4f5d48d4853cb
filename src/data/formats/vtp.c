/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes polygons in VTK's format. Read vtp.h first. */
#include "data/formats/vtp.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS, CORNERS, ENDS, VALUES };

static uint64_t bytes_of(const struct vtp_array *array) {
    return (uint64_t)(array->bytes * array->components) * array->rows;
}

uint64_t vtp_place(const struct vtp_array *array, int k) {
    uint64_t place = 0;
    for (int before = 0; before < k; before++)
        place += 8 + bytes_of(&array[before]);
    return place;
}

static void write_reference(FILE *file, const struct vtp_array *array, int k) {
    fprintf(file,
            "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" "
            "offset=\"%" PRIu64 "\"/>\n",
            array[k].type, array[k].name, array[k].components, vtp_place(array, k));
}

static void write_text(FILE *file, const struct vtp_content *content) {
    const struct vtp_array *array = content->array;
    const union {
        uint16_t number;
        uint8_t byte[2];
    } order = {.number = 1};
    fprintf(file,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\">\n<PolyData>\n<FieldData><DataArray type=\"Float64\" "
            "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">%.17g</DataArray></FieldData>\n"
            "<Piece NumberOfPoints=\"%" PRIu64 "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"%" PRIu64 "\">\n<Points>",
            order.byte[0] ? "LittleEndian" : "BigEndian", content->time, array[POINTS].rows,
            array[ENDS].rows);
    write_reference(file, array, POINTS);
    fprintf(file, "</Points>\n<Polys>");
    write_reference(file, array, CORNERS);
    write_reference(file, array, ENDS);
    fprintf(file, "</Polys>\n<CellData");
    if (content->scalars)
        fprintf(file, " Scalars=\"%s\"", content->scalars);
    if (content->vectors)
        fprintf(file, " Vectors=\"%s\"", content->vectors);
    fprintf(file, ">");
    for (int k = VALUES; k < content->arrays; k++)
        write_reference(file, array, k);
    fprintf(file, "</CellData>\n</Piece>\n</PolyData>\n");
}

void vtp_write(FILE *file, const struct vtp_content *content) {
    static const char data[] = "<AppendedData encoding=\"raw\">\n_";
    char *text = NULL;
    size_t used = 0;
    FILE *head = open_memstream(&text, &used);
    if (head == NULL)
        error_fatal("out of memory: polygons");
    write_text(head, content);
    fclose(head);
    const size_t all = used + strlen(data);
    fprintf(file, "%s%*s%s", text, content->head > all ? (int)(content->head - all) : 0, "", data);
    free(text);
    for (int k = 0; k < content->arrays; k++) {
        const uint64_t bytes = bytes_of(&content->array[k]);
        fwrite(&bytes, sizeof bytes, 1, file);
        fwrite(content->array[k].data, 1, bytes, file);
    }
    fprintf(file, "\n</AppendedData>\n</VTKFile>\n");
}
