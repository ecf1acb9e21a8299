#pragma once
// How far apart processors are, as threads that share out work notice it.

namespace fettle::bench {

/// Nanoseconds that a word takes from one thread to another and back, the best of some tries. Where
/// both are halves of one core it is about 50, where they share a cache about 100, else several
/// hundred; where there is no second processor at the moment, thousands.
double round_trip_ns();

}  // namespace fettle::bench
