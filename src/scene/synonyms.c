/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of synonyms. Read synonyms.h first. */
#include "scene/synonyms.h"

#include <ctype.h>
#include <stddef.h>

static const struct synonym table[] = {
    {"rho", "density", NULL},
    {"dens", "density", NULL},
    {"mass_density", "density", NULL},
    {"youngs_modulus", "young", NULL},
    {"young_modulus", "young", NULL},
    {"youngs", "young", NULL},
    {"elastic_modulus", "young", NULL},
    {"e_modulus", "young", NULL},
    {"modulus", "young", NULL},
    {"nu", "poisson", NULL},
    {"poisson_ratio", "poisson", NULL},
    {"poissons_ratio", "poisson", NULL},
    {"poisson_number", "poisson", NULL},
    {"mu", "friction viscosity", NULL},
    {"mu_s", "friction", NULL},
    {"friction_coefficient", "friction", NULL},
    {"coefficient_of_friction", "friction", NULL},
    {"friction_angle", "friction", "its tangent"},
    {"mu_r", "rolling_friction", NULL},
    {"rolling", "rolling_friction contact.rolling", NULL},
    {"rolling_resistance", "rolling_friction contact.rolling", NULL},
    {"e", "restitution young", NULL},
    {"e_n", "restitution", NULL},
    {"cor", "restitution", NULL},
    {"restitution_coefficient", "restitution", NULL},
    {"coefficient_of_restitution", "restitution", NULL},
    {"kn", "k_n", NULL},
    {"kt", "k_t", NULL},
    {"stiffness", "k_n young", NULL},
    {"normal_stiffness", "k_n", NULL},
    {"tangential_stiffness", "k_t", NULL},
    {"damping_coefficient", "gamma_n", NULL},
    {"gamma", "surface_energy gamma_n", NULL},
    {"cohesion", "cohesion contact.cohesion", NULL},
    {"adhesion", "surface_energy contact.cohesion", NULL},
    {"hertz_mindlin", "contact.law", NULL},
    {"contact_model", "contact.law", NULL},
    {"contact_law", "contact.law", NULL},
    {"model", "law", NULL},
    {"interactions", "material_pairs", NULL},
    {"material", "materials", NULL},
    {"timestep", "dt step.dt", NULL},
    {"time_step", "dt step.dt", NULL},
    {"delta_t", "dt step.dt", NULL},
    {"steps", "count step.count", NULL},
    {"nsteps", "count step.count", NULL},
    {"n_steps", "count step.count", NULL},
    {"end_time", "duration", NULL},
    {"t_end", "duration", NULL},
    {"t_max", "duration", NULL},
    {"total_time", "duration", NULL},
    {"time", "duration", NULL},
    {"diameter", "radius sizes", "half of the diameter"},
    {"diameters", "radii sizes", "half of the diameters"},
    {"d", "radius sizes", "half of the diameter"},
    {"r", "radius", NULL},
    {"size", "sizes radius upper box.upper", NULL},
    {"psd", "sizes", NULL},
    {"size_distribution", "sizes", NULL},
    {"distribution", "law sizes", NULL},
    {"fraction", "volume_fraction", NULL},
    {"number", "count", NULL},
    {"n", "count", NULL},
    {"particle_count", "count", NULL},
    {"shape", "from region", NULL},
    {"x", "position", NULL},
    {"pos", "position", NULL},
    {"center", "centre position", NULL},
    {"v", "velocity", NULL},
    {"vel", "velocity", NULL},
    {"angular_velocity", "omega rate", NULL},
    {"spin", "omega", NULL},
    {"rpm", "rate", NULL},
    {"g", "gravity", NULL},
    {"domain_size", "box.upper", NULL},
    {"dimension", "box.dimension", NULL},
    {"dimensions", "dimension box.dimension", NULL},
    {"dim", "dimension box.dimension", NULL},
    {"pbc", "periodic box.periodic", NULL},
    {"periodic", "box.periodic", NULL},
    {"boundary", "periodic box.periodic", NULL},
    {"boundaries", "periodic box.periodic walls", NULL},
    {"type", "shape kind law from name", NULL},
    {"kind", "shape kind from", NULL},
    {"stl", "file", NULL},
    {"path", "file", NULL},
    {"filename", "file", NULL},
    {"mesh", "file", NULL},
    {"wall", "walls", NULL},
    {"geometry", "walls", NULL},
    {"particle", "particles", NULL},
    {"spheres", "particles", NULL},
    {"random_seed", "seed", NULL},
    {"omp_threads", "threads", NULL},
    {"num_threads", "threads", NULL},
    {"nthreads", "threads", NULL},
    {"neighbor", "skin index", NULL},
    {"neighbour", "skin index", NULL},
    {"verlet_skin", "skin", NULL},
    {"neighbor_list", "index", NULL},
    {"grid", "index", NULL},
    {"vtk", "trajectory output.trajectory", "ParaView opens its XDMF file"},
    {"paraview", "trajectory output.trajectory", "ParaView opens its XDMF file"},
    {"hdf5", "trajectory output.trajectory", NULL},
    {"csv", "observables", NULL},
    {"thermo", "observables", NULL},
    {"restart", "checkpoint output.checkpoint", NULL},
    {"interval", "every", NULL},
    {"frequency", "every frequency", NULL},
    {"freq", "every frequency", NULL},
    {"save_every", "every", NULL},
    {"output_interval", "every output.trajectory.every", NULL},
    {"thermal_conductivity", "conductivity heat.materials[].conductivity", NULL},
    {"specific_heat", "capacity heat.materials[].capacity", NULL},
    {"heat_capacity", "capacity heat.materials[].capacity", NULL},
    {"dynamic_viscosity", "viscosity", NULL},
};

static int is_word(const char *word, const char *text) {
    for (; *word && *text; word++, text++)
        if (*word != (*text == '-' ? '_' : tolower((unsigned char)*text)))
            return 0;
    return *word == *text;
}

const struct synonym *synonyms_get(int k) {
    return k < (int)(sizeof(table) / sizeof(table[0])) ? &table[k] : NULL;
}

const struct synonym *synonyms_find(const char *word) {
    const struct synonym *synonym = NULL;
    for (int k = 0; (synonym = synonyms_get(k)); k++)
        if (is_word(synonym->word, word))
            break;
    return synonym;
}
