#pragma once

namespace weft::bench {

/// Registers the kernels, and whole frames of every method, with Google Benchmark.
void register_benchmarks();

/// Prints the machine's roofs, and for each kernel on draped sheets what it moves and computes and the part
/// of the roof that it reaches.
void print_roofline(int threads);

/// Prints median frame times of the scenes of MEASUREMENTS.md, side by side with Bullet where it was found.
void print_peers();

/// Prints what frames take on a host's naive pool over oneTBB's threads, and as a general mesh over a grid.
void print_ratios();

/// Prints what each call of a World costs, in microseconds.
void print_calls();

}  // namespace weft::bench
