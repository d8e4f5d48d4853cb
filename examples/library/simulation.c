/* SPDX-License-Identifier: BSD-3-Clause */
/* A simulation with a force of one's own: a spring pulls each grain to the plane x = 0. The first grain meets
 * nobody, so it swings as the cosine, which is checked.
 *
 *     cc simulation.c -o simulation $(pkg-config --cflags --libs scree) -lm && ./simulation */
#include <math.h>
#include <scree.h>
#include <stdio.h>
#include <stdlib.h>

static const char scene[] = "units: none\n"
                            "duration: 10\n"
                            "box: {lower: [-5, -5, -5], upper: [5, 5, 5]}\n"
                            "step: {dt: 0.001}\n"
                            "materials:\n"
                            "  - {name: glass, density: 1, young: 1000, poisson: 0.2}\n"
                            "material_pairs:\n"
                            "  - {restitution: 0.5}\n"
                            "particles:\n"
                            "  sources:\n"
                            "    - {from: single, position: [1, 0, 0], radius: 0.5}\n"
                            "    - {from: single, position: [0, 3, 0], radius: 0.1}\n"
                            "    - {from: single, position: [0, 3.1, 3], radius: 0.2}\n"
                            "observables: {every: 1000, list: [{name: position, id: 1, label: first}]}\n";

/* Stiffness of the springs over the mass of a grain. */
static const double stiffness = 4;

/* Adds -stiffness m x to the force along x on each grain. */
static void pull(void *context, struct scree_simulation *simulation) {
    struct scree_field x, f, w;
    struct scree_box box = scree_box(simulation);
    (void)context;
    scree_field(simulation, "position", &x);
    scree_field(simulation, "force", &f);
    scree_field(simulation, "inverse_mass", &w);
    for (size_t k = 0; k < x.count; k++) {
        const double *position = (const double *)((char *)x.data + k * x.stride);
        double *force = (double *)((char *)f.data + k * f.stride);
        double inverse_mass = *(const double *)((char *)w.data + k * w.stride);
        force[0] -= stiffness / inverse_mass * (position[0] + box.origin[0]);
    }
}

static void say(void *context, const char *line) {
    (void)context;
    fprintf(stderr, "%s\n", line);
}

int main(void) {
    const struct scree_options options = {.force = pull, .log = say};
    struct scree_error error;
    double worst = 0;
    struct scree_simulation *simulation = scree_create("springs", scene, &options, &error);
    if (simulation == NULL || !scree_step(simulation, scree_steps_left(simulation), &error)) {
        fprintf(stderr, "simulation: %s\n", error.text);
        scree_destroy(&simulation);
        return EXIT_FAILURE;
    }
    for (size_t k = 0; k < scree_rows(simulation); k++) {
        const double *row = scree_row(simulation, k); /* time, x, y, z */
        double error_here = fabs(row[1] - cos(sqrt(stiffness) * row[0]));
        worst = error_here > worst ? error_here : worst;
        printf("t = %4.1f, x = %9.6f\n", row[0], row[1]);
    }
    printf("%zu rows, largest error %.1e\n", scree_rows(simulation), worst);
    scree_destroy(&simulation);
    return worst < 1e-5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
