#pragma once
// A simple implementation of the behavior of a tree: instances in a list, cells in maps, formulas
// recomputed at every read, and complete copies for undo.

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::property::testing {

/// A formula as data: its sources and the operation.
struct Recipe {
    enum Kind { sum, choice, difference, demanding, kinds };
    Kind kind = sum;
    int first = 0, second = 0;            // instances
    std::string first_name, second_name;  // properties
    bool by_path = false;                 // reads "world.n3.mass" instead of following a handle
    double constant = 0;
    bool operator==(const Recipe&) const = default;

    /// The result, computed from the values of `read(instance, property)`; reads only the needed
    /// ones.
    template <class Read>
    double operator()(const Read& read) const;
};

/// Thrown when a cell in error is read.
class InError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct NaiveInstance {
    bool alive = true;
    int parent = -1;  // -1: the world
    std::string name;
    std::vector<int> children;
    std::map<std::string, double>
        values;  // of all cells; for a cell with a formula, the value before it
    std::map<std::string, Recipe> formulas;
    bool operator==(const NaiveInstance&) const = default;
};

class NaiveWorld {
  public:
    std::vector<NaiveInstance> instances;
    std::vector<int> top;  // children of the world
    bool operator==(const NaiveWorld&) const = default;

    int create(const std::string& name);
    void destroy(int instance);
    /// Moves the instance to the end of the children of `parent`; -1 is the world.
    void move(int instance, int parent);
    bool is_below(int instance, int ancestor) const;
    std::vector<int> alive() const;
    std::vector<int>& children_of(int parent);

    /// The value, with all its sources recomputed. Throws InError.
    double read(int instance, const std::string& property) const;
    /// The value after an assignment; throws InError if it is refused.
    static double coerced(const std::string& property, double value);
    static double default_of(const std::string& property);
    static bool declared(const std::string& property);

  private:
    using Cell = std::pair<int, std::string>;
    using Results = std::map<Cell, std::optional<double>>;
    double evaluate(const Cell& cell, Results& results) const;
    int named(const std::string& name) const;
};

template <class Read>
double Recipe::operator()(const Read& read) const {
    const double a = read(first, first_name);
    switch (kind) {
        case choice:
            return a > constant ? read(second, second_name) : constant;
        case difference: {
            const double b = read(second, second_name);
            return a > b ? a - b : b - a;
        }
        case demanding:
            if (a < constant) throw std::runtime_error("too little");
            return a;
        default: {
            const double total = a + read(second, second_name) + constant;
            return total < 40 ? total : total / 8;
        }
    }
}

}  // namespace fettle::property::testing
