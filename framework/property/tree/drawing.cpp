#include <fettle/property/drawing.h>

#include <algorithm>
#include <utility>

namespace fettle::property {
namespace {

thread_local double moment = 1;

}  // namespace

Drawing::Drawing(double alpha) : before_(std::exchange(moment, std::clamp(alpha, 0.0, 1.0))) {}

Drawing::~Drawing() {
    moment = before_;
}

double Drawing::alpha() {
    return moment;
}

}  // namespace fettle::property
