#include <geometry/decomposition.h>
#include <geometry/orientation.h>

#include <algorithm>

// Cutting along diagonals between vertices. Each cut starts at a reflex vertex. The best end is
// another reflex vertex, so that both vertices become convex in both halves. The second best end is
// anywhere in the wedge between the two extended edges, so that at least the first vertex becomes
// convex (M. Bayazit, "Decomposing polygons into convex regions", 2008, uses the same wedge). Among
// equal cuts the shortest is used. Finally, unnecessary diagonals are removed (S. Hertel and K.
// Mehlhorn, "Fast triangulation of simple polygons", 1983).

namespace fettle::physics::detail {
namespace {

using Indices = std::vector<uint32_t>;

class Cutter {
  public:
    explicit Cutter(std::span<const Vec2> points) : p_(points) {
        double extent = 0.0;
        for (Vec2 p : points) extent = std::max(extent, double(length(p - points[0])));
        tolerance_ = 1e-9 * extent * extent;
    }

    std::vector<Indices> cut() {
        Indices all(p_.size());
        for (uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        std::vector<Indices> open{std::move(all)};
        while (!open.empty()) {
            Indices piece = std::move(open.back());
            open.pop_back();
            size_t from, to;
            if (!best_cut(piece, from, to)) {
                pieces_.push_back(std::move(piece));
                continue;
            }
            const auto [low, high] = std::minmax(from, to);
            Indices inner(piece.begin() + std::ptrdiff_t(low),
                          piece.begin() + std::ptrdiff_t(high) + 1);
            Indices outer(piece.begin() + std::ptrdiff_t(high), piece.end());
            outer.insert(outer.end(), piece.begin(), piece.begin() + std::ptrdiff_t(low) + 1);
            open.push_back(std::move(outer));
            open.push_back(std::move(inner));
        }
        join();
        return std::move(pieces_);
    }

  private:
    double turn(uint32_t o, uint32_t a, uint32_t b) const {
        return orientation(p_[o], p_[a], p_[b]);
    }
    static uint32_t before(const Indices& q, size_t i) { return q[(i + q.size() - 1) % q.size()]; }
    static uint32_t after(const Indices& q, size_t i) { return q[(i + 1) % q.size()]; }
    bool reflex(const Indices& q, size_t i) const {
        return turn(before(q, i), q[i], after(q, i)) < -tolerance_;
    }
    /// True if `target` is visible from vertex k between its two edges.
    bool opens_to(const Indices& q, size_t k, uint32_t target) const {
        const double left = turn(before(q, k), q[k], target),
                     right = turn(q[k], after(q, k), target);
        return reflex(q, k) ? !(left <= 0.0 && right <= 0.0) : left > 0.0 && right > 0.0;
    }
    /// True if a cut from k to `target` makes both angles at k convex.
    bool makes_convex(const Indices& q, size_t k, uint32_t target) const {
        return turn(before(q, k), q[k], target) >= -tolerance_ &&
               turn(target, q[k], after(q, k)) >= -tolerance_;
    }
    bool visible(const Indices& q, size_t i, size_t j) const {
        const uint32_t a = q[i], b = q[j];
        for (size_t k = 0; k < q.size(); ++k) {
            const size_t l = (k + 1) % q.size();
            if (k == i || k == j || l == i || l == j) continue;
            const double ka = turn(a, b, q[k]), la = turn(a, b, q[l]);
            if ((ka > 0.0 && la > 0.0) || (ka < 0.0 && la < 0.0)) continue;
            const double ak = turn(q[k], q[l], a), bk = turn(q[k], q[l], b);
            if ((ak > 0.0 && bk > 0.0) || (ak < 0.0 && bk < 0.0)) continue;
            return false;
        }
        // The two edges at either end may block the view, too.
        for (size_t k : {(i + 1) % q.size(), (i + q.size() - 1) % q.size(), (j + 1) % q.size(),
                         (j + q.size() - 1) % q.size()}) {
            if (k == i || k == j || turn(a, b, q[k]) != 0.0) continue;
            const Vec2 u = p_[b] - p_[a], v = p_[q[k]] - p_[a];
            if (dot(u, v) > 0.0f && dot(v, v) < dot(u, u)) return false;
        }
        return true;
    }

    bool best_cut(const Indices& q, size_t& from, size_t& to) const {
        struct Cut {
            int convex;
            float length;
            size_t from, to;
        };
        std::vector<Cut> candidates;
        // In a small outline, all reflex vertices are tested against all others. In a long outline,
        // only the first few are tested, because their cuts are short anyway. A long outline also
        // needs many cuts, so the limit for the total cost is the same for all outlines.
        size_t budget = std::min(size_t{1} << 18, (size_t{1} << 26) / p_.size());
        bool any = false;
        for (size_t i = 0; i < q.size() && (!any || budget >= q.size()); ++i) {
            if (!reflex(q, i)) continue;
            any = true;
            budget -= std::min(budget, q.size());
            for (size_t j = 0; j < q.size(); ++j) {
                const size_t apart = i > j ? i - j : j - i;
                if (apart < 2 || apart + 1 >= q.size()) continue;
                if (!opens_to(q, i, q[j]) || !opens_to(q, j, q[i])) continue;
                const int convex =
                    int(makes_convex(q, i, q[j])) + int(reflex(q, j) && makes_convex(q, j, q[i]));
                candidates.push_back({convex, length(p_[q[i]] - p_[q[j]]), i, j});
            }
        }
        // A heap with the best cut on top: nearly always one of the first is used, so the others
        // need not be sorted.
        const auto worse = [](const Cut& a, const Cut& b) {
            if (a.convex != b.convex) return a.convex < b.convex;
            if (a.length != b.length) return a.length > b.length;
            return a.from != b.from ? a.from > b.from : a.to > b.to;
        };
        std::make_heap(candidates.begin(), candidates.end(), worse);
        for (; !candidates.empty(); candidates.pop_back()) {
            const Cut& candidate = candidates.front();
            if (visible(q, candidate.from, candidate.to)) {
                from = candidate.from;
                to = candidate.to;
                return true;
            }
            std::pop_heap(candidates.begin(), candidates.end(), worse);
        }
        return false;
    }

    /// Joins two pieces at a common edge; empty if the result would not be convex.
    Indices joined(const Indices& a, size_t edge_a, const Indices& b, size_t edge_b) const {
        Indices whole;
        for (size_t k = 1; k <= a.size(); ++k) whole.push_back(a[(edge_a + k) % a.size()]);
        for (size_t k = 2; k < b.size(); ++k) whole.push_back(b[(edge_b + k) % b.size()]);
        for (size_t k : {size_t{0}, a.size() - 1})
            if (turn(before(whole, k), whole[k], after(whole, k)) < -tolerance_) return {};
        return whole;
    }

    bool join_one() {
        for (size_t x = 0; x < pieces_.size(); ++x) {
            const Indices& a = pieces_[x];
            for (size_t i = 0; i < a.size(); ++i) {
                const uint32_t from = a[i], to = after(a, i);
                if (to == (from + 1) % p_.size()) continue;  // an edge of the outline
                for (size_t y = x + 1; y < pieces_.size(); ++y) {
                    const Indices& b = pieces_[y];
                    const auto at = std::find(b.begin(), b.end(), to);
                    if (at == b.end()) continue;
                    const auto k = size_t(at - b.begin());
                    if (after(b, k) != from) continue;
                    Indices whole = joined(a, i, b, k);
                    if (whole.empty()) continue;
                    pieces_[x] = std::move(whole);
                    pieces_.erase(pieces_.begin() + std::ptrdiff_t(y));
                    return true;
                }
            }
        }
        return false;
    }
    void join() {
        constexpr size_t few = 256;  // for more pieces, searching the list would be slow
        if (pieces_.size() > few) return;
        while (join_one()) {
        }
    }

    std::span<const Vec2> p_;
    double tolerance_ = 0.0;
    std::vector<Indices> pieces_;
};

}  // namespace

std::vector<std::vector<uint32_t>> convex_pieces(std::span<const Vec2> outline) {
    if (outline.size() < 3) return {};
    return Cutter(outline).cut();
}

}  // namespace fettle::physics::detail
