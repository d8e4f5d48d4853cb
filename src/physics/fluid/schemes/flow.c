/* SPDX-License-Identifier: BSD-3-Clause */
/* Numbers of rows, views of arrays and means of a flow. Read flow.h first. */
#include "physics/fluid/schemes/flow.h"

int64_t flow_number(const struct flow *flow) {
    const struct weights *weights = flow->weights;
    int64_t rows = (int64_t)weights->rows, first = comm_scan(flow->comm, rows);
    for (size_t row = 0; row < weights->rows; row++)
        flow->row[weights->first + row] = first + (int64_t)row;
    flow_forward(flow, FLOW_ROW);
    comm_sum_int(flow->comm, &rows, 1);
    return rows;
}

void flow_forward(const struct flow *flow, enum flow_array array) {
    if (flow->forward != NULL)
        flow->forward(flow, array);
}

struct operators_values flow_velocity(const struct flow *flow) {
    return (struct operators_values){.value = flow->velocity, .stride = flow->velocity_stride};
}

struct operators_values flow_pressure(const struct flow *flow) {
    return (struct operators_values){flow->pressure, 1, 1};
}

struct operators_values flow_predicted(const struct flow *flow) {
    return (struct operators_values){.value = flow->predicted, .stride = 3};
}

struct operators_values flow_increment(const struct flow *flow) {
    return (struct operators_values){.value = flow->increment, .stride = 1};
}

struct operators_values flow_drift(const struct flow *flow) {
    return (struct operators_values){.value = flow->drift, .stride = 3};
}

struct operators_values flow_gradient(const struct flow *flow) {
    return (struct operators_values){.value = flow->gradient, .stride = 3};
}

void flow_mean(const struct flow *flow, struct operators_values value, double mean[3], double *volume) {
    const struct weights *weights = flow->weights;
    double sum[4] = {0};
    for (size_t row = 0; row < weights->rows; row++) {
        const double *v = value.value + (weights->first + row) * value.stride;
        for (int d = 0; d < 3; d++)
            sum[d] += weights->volume[row] * v[d];
        sum[3] += weights->volume[row];
    }
    comm_sum(flow->comm, sum, 4);
    for (int d = 0; d < 3; d++)
        mean[d] = sum[3] > 0 ? sum[d] / sum[3] : 0;
    *volume = sum[3];
}
