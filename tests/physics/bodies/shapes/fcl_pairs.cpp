// SPDX-License-Identifier: BSD-3-Clause
// Reads what rock_pairs writes, and compares it with FCL: who is apart, how far, along which normal, and how deep the others overlap. Exit
// status 1 if they differ. tests/rock_distance.sh builds it.
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fcl/fcl.h>
#include <memory>
#include <vector>

using Convex = fcl::Convex<double>;
using Vector = fcl::Vector3<double>;

enum { TURNS = 100 };

struct Record {
    double turn[9], apart[3];
    int64_t parted;
    double length, normal[3];
};

static std::shared_ptr<Convex> read_solid() {
    int32_t count[2];
    if (fread(count, sizeof count, 1, stdin) != 1)
        return nullptr;
    auto corners = std::make_shared<std::vector<Vector>>(count[0]);
    auto faces = std::make_shared<std::vector<int>>(count[1]);
    for (auto &corner : *corners)
        if (fread(corner.data(), sizeof(double), 3, stdin) != 3)
            return nullptr;
    if (fread(faces->data(), sizeof(int), faces->size(), stdin) != faces->size())
        return nullptr;
    int number = 0;
    for (size_t k = 0; k < faces->size(); k += 1 + (*faces)[k])
        number++;
    return std::make_shared<Convex>(corners, number, faces);
}

// gjk_distance takes cores that are nearer than a millionth of their size for cores that touch.
static const double touching = 4e-6;

static const char *verdict(bool good) {
    return good ? "passed" : "FAILED";
}

int main() {
    long pairs = 0, parted = 0, unlike = 0, off = 0, deep = 0, shallow = 0;
    double worst = 0, turned = 0, nearest = 0;
    for (std::shared_ptr<Convex> a; (a = read_solid());) {
        auto b = read_solid();
        for (int m = 0; b && m < TURNS; m++) {
            Record record;
            if (fread(&record, sizeof record, 1, stdin) != 1)
                return 1;
            fcl::Transform3<double> still = fcl::Transform3<double>::Identity(), moved = still;
            for (int r = 0; r < 3; r++) {
                for (int c = 0; c < 3; c++)
                    moved.linear()(r, c) = record.turn[3 * r + c];
                moved.translation()[r] = record.apart[r];
            }
            fcl::DistanceRequest<double> request(true, true);
            request.gjk_solver_type = fcl::GST_LIBCCD;
            request.distance_tolerance = 1e-10;
            fcl::DistanceResult<double> result;
            const double theirs = fcl::distance(a.get(), still, b.get(), moved, request, result);
            pairs++;
            if ((theirs > 0) != (record.parted != 0)) {
                nearest = std::fmax(nearest, std::fabs(record.length));
                unlike += std::fabs(record.length) > touching;
                continue;
            }
            if (record.parted) {
                parted++;
                const double error = std::fabs(theirs - record.length);
                worst = std::fmax(worst, error);
                off += error > 1e-6;
                Vector way = result.nearest_points[1] - result.nearest_points[0], ours(record.normal);
                if (record.length > 1e-3)
                    turned = std::fmax(turned, (way.normalized() - ours).norm());
            } else if (record.length > 1e-3) {
                deep++;
                shallow += std::fabs(-theirs - record.length) > 1e-5;
            }
        }
    }
    printf("%ld pairs: %ld unlike (those nearer than %.2g left out, of which the widest was %.2g); of %ld "
           "apart the distances differ by at most %.2g (%ld by more than "
           "1e-6), the normals by at most %.2g; of %ld that overlap %ld "
           "depths differ by more than 1e-5\n",
           pairs, unlike, touching, nearest, parted, worst, off, turned, deep, shallow);
    const bool good =
        pairs > 0 && parted > pairs / 10 && unlike == 0 && off <= parted / 1000 && shallow <= deep / 100;
    printf("%s\n", verdict(good));
    return good ? 0 : 1;
}
