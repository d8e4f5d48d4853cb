/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads OBJ and PLY by assimp. Read mesh.h first. */
#include "config.h"
#include "walls/mesh.h"
#include "core/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

const char *mesh_import_format(const char *content, const char *path) {
    size_t length = strlen(path);
    const char *end = length > 4 ? path + length - 4 : "";
    if (strncmp(content, "ply", 3) == 0 && (content[3] == '\n' || content[3] == '\r'))
        return "ply";
    while (*content == '#' || *content == '\n' || *content == '\r') /* comments and empty lines */
        content += *content == '#' ? strcspn(content, "\n") : 1;
    bool object = strncmp(content, "v ", 2) == 0 || strncmp(content, "o ", 2) == 0 ||
                  strncmp(content, "g ", 2) == 0 || strncmp(content, "mtllib ", 7) == 0;
    return object || strcasecmp(end, ".obj") == 0 ? "obj" : NULL;
}

#ifdef HAVE_ASSIMP
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dlfcn.h>

/* The functions that are needed; their types are those of assimp's header. */
struct importer {
    __typeof__(&aiImportFileFromMemory) import;
    __typeof__(&aiReleaseImport) release;
    __typeof__(&aiGetErrorString) why;
};

static bool importer_load(struct importer *importer, const char *path, struct error *error) {
    void *library = dlopen(ASSIMP_LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == NULL)
        return error_set(
            error, ERROR_USER,
            "%s: assimp, which reads such files, is not there (%s; Debian: libassimp5); install it, "
            "or export the mesh as STL",
            path, dlerror());
    *(void **)&importer->import = dlsym(library, "aiImportFileFromMemory");
    *(void **)&importer->release = dlsym(library, "aiReleaseImport");
    *(void **)&importer->why = dlsym(library, "aiGetErrorString");
    return (importer->import && importer->release && importer->why) ||
           error_set(error, ERROR_USER, "%s: %s lacks functions that are needed; export the mesh as STL",
                     path, ASSIMP_LIBRARY);
}

/* Adds the triangles of one part of the file. */
static bool add_part(struct mesh *mesh, const struct aiMesh *part, const char *path, struct error *error) {
    for (unsigned f = 0; f < part->mNumFaces; f++) {
        const struct aiFace *face = &part->mFaces[f];
        if (face->mNumIndices != 3) /* points and lines */
            continue;
        double *corner = mesh->corner[mesh->count++];
        for (int c = 0; c < 3; c++) {
            const struct aiVector3D *at = &part->mVertices[face->mIndices[c]];
            corner[3 * c] = (double)at->x;
            corner[3 * c + 1] = (double)at->y;
            corner[3 * c + 2] = (double)at->z;
        }
        for (int c = 0; c < 9; c++)
            if (!isfinite(corner[c]))
                return error_set(error, ERROR_USER, "%s: triangle %zu: corner %d is not finite", path,
                                 mesh->count, c / 3 + 1);
    }
    return true;
}

bool mesh_import(struct mesh *mesh, char *content, size_t size, const char *format, const char *path,
                 struct error *error) {
    struct importer importer = {0};
    bool object = strcmp(format, "obj") == 0;
    if (!importer_load(&importer, path, error))
        return false;
    char *plain = object ? mesh_obj_plain(content, path, &size, error) : NULL;
    if (object && plain == NULL)
        return false;
    const struct aiScene *scene =
        importer.import(plain ? plain : content, (unsigned)size,
                        aiProcess_Triangulate | aiProcess_PreTransformVertices, format);
    free(plain);
    if (scene == NULL)
        return error_set(error, ERROR_USER, "%s: assimp cannot read it as %s: %s", path,
                         object ? "OBJ" : "PLY", importer.why());
    size_t faces = 0;
    bool good = true;
    for (unsigned k = 0; k < scene->mNumMeshes; k++)
        faces += scene->mMeshes[k]->mNumFaces;
    mesh->corner = memory_allocate(faces, sizeof *mesh->corner, "triangles");
    for (unsigned k = 0; good && k < scene->mNumMeshes; k++)
        good = add_part(mesh, scene->mMeshes[k], path, error);
    importer.release(scene);
    return good;
}
#else
bool mesh_import(struct mesh *mesh, char *content, size_t size, const char *format, const char *path,
                 struct error *error) {
    (void)mesh, (void)content, (void)size;
    return error_set(
        error, ERROR_USER,
        "%s: is %s file, which this program cannot read, as it was built without assimp (Debian: "
        "libassimp-dev); export the mesh as STL",
        path, strcmp(format, "obj") == 0 ? "an OBJ" : "a PLY");
}
#endif
