// Ten thousand formulas in a chain, a fan and a grid, compared with a model that recomputes
// everything: values, errors and their recovery, and the number of calls of each formula.

#include <cmath>
#include <optional>

#include "catch.h"
#include "fixture.h"

namespace formula_network_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// A number of the model; empty: in error.
using Number = std::optional<double>;

/// Cells c0, c1 ... of one instance: first sources, then formulas, each of two cells.
class Network {
  public:
    static constexpr int sources = 50, chain = 2'500, fan = 2'500, grid = 5'000;
    static constexpr int formulas = chain + fan + grid;

    Network() {
        for (int i = 0; i < sources; ++i) tree.set_or_add(home, name(i), 1.0);
        given.assign(sources, 1.0);
        for (int i = 0; i < chain; ++i) add(i == 0 ? 0 : last(), 1);
        middle = last();
        for (int i = 0; i < fan; ++i) add(2, 3 + i % 7);
        const int top = count();
        for (int i = 0; i < grid; ++i) {
            const int row = i / sources, column = i % sources;
            const int above = row == 0 ? column : top + i - sources;
            const int beside = row == 0 ? (column + 1) % sources
                                        : top + (row - 1) * sources + (column + 1) % sources;
            add(above, beside);
        }
    }

    static std::string name(int cell) { return "c" + std::to_string(cell); }
    int count() const { return sources + static_cast<int>(ways.size()); }
    int last() const { return count() - 1; }

    void set(int source, double value) {
        given[static_cast<std::size_t>(source)] = value;
        tree.set(home, name(source), value);
    }

    /// The expected value of every cell.
    std::vector<Number> model() const {
        std::vector<Number> all(given.begin(), given.end());
        for (const auto& [a, b] : ways) {
            const Number first = all[static_cast<std::size_t>(a)];
            Number result;
            if (first && *first >= 0) {
                const bool needs_second = *first > 0.5;
                const Number second =
                    needs_second ? all[static_cast<std::size_t>(b)] : Number(0.25);
                if (second) result = std::fmod(*first + *second, 3.0);
            }
            all.push_back(result);
        }
        return all;
    }

    /// Number of cells that differ from the model.
    int wrong() const {
        const std::vector<Number> expected = model();
        int count = 0;
        for (int i = 0; i < this->count(); ++i) {
            const Property& property = tree.property(home, name(i));
            Number found;
            try {
                found = tree.get(home, property).as_double();
            } catch (const Error&) {
                // in error
            }
            count += found != expected[static_cast<std::size_t>(i)];
        }
        return count;
    }

    /// The largest number of calls of one formula since the last query.
    int max_runs() {
        int max = 0;
        for (int& n : runs) max = std::max(max, std::exchange(n, 0));
        return max;
    }

    Tree tree;
    Handle home = tree.create(tree.object_class(), tree.root(), "home");
    std::vector<double> given;
    std::vector<std::pair<int, int>> ways;
    std::vector<int> runs = std::vector<int>(formulas);
    int middle = 0;

  private:
    // The second cell is read only if the first is large, so the dependencies change often.
    void add(int a, int b) {
        const int number = static_cast<int>(ways.size());
        ways.emplace_back(a, b);
        tree.set_formula(home, name(sources + number),
                         {[this, number, from = name(a), to = name(b)](const Tree& t) {
                              ++runs[static_cast<std::size_t>(number)];
                              const double first = t.get(home, from).number();
                              if (first < 0) throw std::runtime_error("below zero");
                              return Value(std::fmod(
                                  first + (first > 0.5 ? t.get(home, to).number() : 0.25), 3.0));
                          },
                          name(a) + " + " + name(b)});
    }
};

}  // namespace

TEST_CASE(
    "ten thousand formulas run at most once per barrier and have the values of a full "
    "recomputation") {
    Network n;
    REQUIRE(n.tree.formula_count() == Network::formulas);
    n.tree.barrier();
    CHECK(n.max_runs() == 1);
    CHECK(n.wrong() == 0);
    std::uint32_t seed = 7;
    for (int round = 0; round < 12; ++round) {
        for (int edit = 0; edit < 4; ++edit) {
            seed = seed * 1664525u + 1013904223u;
            n.set(static_cast<int>(seed >> 16) % Network::sources,
                  static_cast<double>(seed >> 8 & 15u) / 8);
        }
        n.tree.barrier();
        CHECK(n.max_runs() <= 1);
        CHECK(n.wrong() == 0);
        CHECK(n.max_runs() == 0);  // reading a settled formula does not call it
    }
}

TEST_CASE("an error spreads to all formulas that read it and disappears with its cause") {
    Network n;
    n.tree.barrier();
    (void)n.max_runs();
    // In the chain, the fan and the grid: a source, and a formula that reads it.
    const int fan = Network::sources + Network::chain, grid = fan + Network::fan;
    for (const auto& [source, reader] :
         {std::pair(0, Network::sources), std::pair(2, fan), std::pair(17, grid + 17)}) {
        n.set(source, -1);
        n.tree.barrier();
        CHECK(n.max_runs() <= 1);
        CHECK(n.wrong() == 0);
        CHECK_THAT(n.tree.problem(n.home, n.tree.property(n.home, Network::name(reader))),
                   contains("below zero"));
        n.set(source, 1.25);
        n.tree.barrier();
        CHECK(n.max_runs() <= 1);
        CHECK(n.wrong() == 0);
    }
    // A deleted source is an error, too, until a property with that name exists again.
    n.tree.remove_ad_hoc(n.home, Network::name(0));
    n.tree.barrier();
    const Property& end = n.tree.property(n.home, Network::name(n.middle));
    CHECK_THAT(n.tree.problem(n.home, end), contains("c0"));
    n.tree.set_or_add(n.home, Network::name(0), n.given[0]);
    n.tree.barrier();
    CHECK(n.wrong() == 0);
}

TEST_CASE("why follows a chain of thousands of formulas to its source") {
    Network n;
    const Explanation why = n.tree.why(n.home, n.tree.property(n.home, Network::name(n.middle)));
    const Explanation* at = &why;
    int links = 0;
    while (!at->from.empty()) {
        CHECK_FALSE(at->source.empty());
        at = &at->from.front();
        ++links;
    }
    CHECK(links == Network::chain);
    CHECK(at->path == "home.c0");
    CHECK(at->value == "1");
}

}  // namespace formula_network_test
