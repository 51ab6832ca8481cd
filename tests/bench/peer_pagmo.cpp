// pagmo2's differential evolution and particle swarm on the same problem, with the evaluation a user would write: local support, one direction after
// the other, doubles in vectors.  peer_pagmo de|pso SIZE prints the seconds of 80,040 evaluations and the best value.
extern "C" {
#include "bench.h"
}
#include "refine_input.h"
#include <cmath>
#include <cstdio>
#include <cstring>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/config.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>
#include <vector>

namespace {

refine_input in;
double N[REFINE_DATA][4];
int first[REFINE_DATA];
double T[REFINE_DATA][REFINE_CONTROL][3];

double distance(int w, int a, int b)
{
    const double *D = in.data + 3 * in.data_class[w][a][b];
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        double s = 0.0;
        for (int k = 0; k < 4; k++) s += N[b][k] * T[a][first[b] + k][d];
        square += (D[d] - s) * (D[d] - s);
    }
    return std::sqrt(square);
}

double evaluate(const double *x)
{
    double sum = 0.0;
    for (int w = 0; w < 2; w++) {
        for (int a = w; a < REFINE_DATA - w; a++)
            for (int j = 0; j < REFINE_CONTROL; j++)
                for (int d = 0; d < 3; d++) {
                    double t = 0.0;
                    for (int k = 0; k < 4; k++) t += N[a][k] * x[3 * in.control_class[w][first[a] + k][j] + d];
                    T[a][j][d] = t;
                }
        for (int a = w; a < REFINE_DATA - w; a++)
            for (int b = w; b < REFINE_DATA - w; b++) sum += distance(w, a, b);
    }
    return sum;
}

struct shell {
    pagmo::vector_double fitness(const pagmo::vector_double &x) const { return {evaluate(x.data())}; }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const
    {
        pagmo::vector_double lo(in.x0, in.x0 + REFINE_N), hi(lo);
        for (double &v : lo) v -= 5e-6;
        for (double &v : hi) v += 5e-6;
        return {lo, hi};
    }
};

}

int main(int argc, char **argv)
{
    const bool swarm = argc > 1 && std::strcmp(argv[1], "pso") == 0;
    refine_input_make(&in);
    for (int a = 0; a < REFINE_DATA; a++) first[a] = refine_input_basis(N[a], &in, in.t[a]);
    const pagmo::algorithm algorithm = swarm ? pagmo::algorithm(pagmo::pso(2000, 0.729, 2.05, 2.05, 0.5, 5, 1, 4, false, 1))
                                             : pagmo::algorithm(pagmo::de(2000, 0.3, 0.8, 7, 0.0, 0.0, 1));
    const double start = bench_cpu();
    pagmo::population population(pagmo::problem(shell{}), 40, 1);
    population = algorithm.evolve(population);
    const double seconds = bench_cpu() - start;
    if (population.get_problem().get_fevals() != REFINE_EVALUATIONS) {
        std::fprintf(stderr, "%llu evaluations\n", static_cast<unsigned long long>(population.get_problem().get_fevals()));
        return 1;
    }
    std::printf("pagmo_%d.%d.%d %.9g %.17g\n", PAGMO_VERSION_MAJOR, PAGMO_VERSION_MINOR, PAGMO_VERSION_PATCH, seconds, population.champion_f()[0]);
    return 0;
}
