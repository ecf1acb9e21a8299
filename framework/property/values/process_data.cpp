#include "process_data.h"

#include <atomic>

namespace fettle::property {
namespace {

std::atomic<int> trees = 0;

}  // namespace

CountedTree::CountedTree() noexcept {
    ++trees;
}

CountedTree::~CountedTree() {
    --trees;
}

bool CountedTree::any() noexcept {
    return trees > 0;
}

}  // namespace fettle::property
