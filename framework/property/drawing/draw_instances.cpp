// Drawing of the instances of a tree.

#include <fettle/property/drawing.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <tree/state.h>

namespace fettle::property {
namespace {

thread_local double drawn_alpha = 1;
thread_local bool drawing_now = false;
thread_local DrawingPart::Part drawn_part = DrawingPart::Part::all;

/// The instances that are drawn, in order. The functions of modules may change the tree, so all
/// instances are collected before the first one is drawn.
class Sheet {
  public:
    Sheet(const Tree& tree, const Instances& instances, Painter& painter, double alpha,
          Drawer* also)
        : tree_(tree), instances_(instances), painter_(painter), alpha_(alpha), also_(also) {
        for (std::uint32_t id = 0; id < instances.classes.size(); ++id) note_class(id);
    }

    void collect(std::uint32_t top) {
        instances_.visit_below(top, [this](std::uint32_t i) {
            const Node& node = instances_.nodes[i];
            const Kind kind = kinds_[node.class_id];
            // Most trees have no z and no layers: then nothing above an instance matters.
            const Above above = depends_on_above_ ? above_of(i, node) : Above{};
            if (kind.draws) drawn_.push_back({instances_.nodes.handle(i), above.z, above.layer});
            if (kind.draws_over)
                over_.push_back({instances_.nodes.handle(i), above.z, above.layer});
        });
        if (!depends_on_above_) return;
        const auto lower = [](const Item& a, const Item& b) { return a.z < b.z; };
        std::stable_sort(drawn_.begin(), drawn_.end(), lower);
        std::stable_sort(over_.begin(), over_.end(), lower);
    }

    void draw() {
        if (drawn_part != DrawingPart::Part::marks) draw_instances();
        if (drawn_part != DrawingPart::Part::instances) draw_marks();
    }

    void draw_instances() {
        draw_all(drawn_, [this](const Item& item) {
            if (also_ != nullptr && instances_.nodes.find(item.self) != nullptr &&
                !also_->begins(item.self))
                return;
            if (const Node* node = instances_.nodes.find(item.self)) {
                const Lifecycle& lifecycle = instances_.class_of(*node).lifecycle();
                if (lifecycle.draw)
                    lifecycle.draw(lifecycle.context, tree_, item.self, node->row, painter_,
                                   alpha_);
            }
            const Node* const node = instances_.nodes.find(item.self);
            if (node != nullptr && kinds_[node->class_id].scripted)
                also_->draw(item.self, painter_);
        });
    }

    void draw_marks() {
        draw_all(over_, [this](const Item& item) {
            const Node* const node = instances_.nodes.find(item.self);
            if (node == nullptr) return;
            const Lifecycle& lifecycle = instances_.class_of(*node).lifecycle();
            lifecycle.draw_over(lifecycle.context, tree_, item.self, node->row, painter_, alpha_);
        });
    }

    /// After an exception: the layers end without a call to their modules.
    void abandon() {
        while (painter_.pushed() > pushed_before_) painter_.pop();
    }

  private:
    struct Kind {
        bool draws = false, draws_over = false, layer = false, scripted = false;
    };
    struct Item {
        Handle self;
        double z = 0;
        std::uint32_t layer = 0;  // index in layers_ plus one; 0: none
    };
    struct Above {
        double z = 0;
        std::uint32_t layer = 0;
    };
    struct Level {
        std::uint32_t index;
        Above below;  // for the instances below this one
    };
    struct Layer {
        Handle self;
        std::uint32_t outer = 0;
    };

    void note_class(std::uint32_t id) {
        const Class& of = instances_.classes[id];
        const Lifecycle& lifecycle = of.lifecycle();
        Kind kind;
        kind.scripted = also_ != nullptr && also_->draws(of);
        kind.draws = lifecycle.draw != nullptr || kind.scripted;
        kind.draws_over = lifecycle.draw_over != nullptr;
        kind.layer = lifecycle.begin_below != nullptr;
        kinds_.push_back(kind);
        const StoredColumns* const stored = instances_.stored[id].get();
        if (stored != nullptr && stored->rows() > 0)
            depends_on_above_ |= kind.layer || stored->any_sparse(z_index);
    }

    /// Visits are in the order of the tree, so the parents form a stack.
    Above above_of(std::uint32_t index, const Node& node) {
        while (!levels_.empty() && levels_.back().index != node.parent) levels_.pop_back();
        Above here = levels_.empty() ? Above{} : levels_.back().below;
        here.z += instances_.stored[node.class_id]->sparse(z_index, node.stored_row);
        if (node.first_child == 0) return here;
        Above below = here;
        if (kinds_[node.class_id].layer) {
            layers_.push_back({instances_.nodes.handle(index), here.layer});
            below.layer = static_cast<std::uint32_t>(layers_.size());
        }
        levels_.push_back({index, below});
        return here;
    }

    /// Draws the items in order; consecutive ones of one layer together.
    template <class Draw>
    void draw_all(const std::vector<Item>& items, Draw draw) {
        for (auto first = items.begin(); first != items.end();) {
            const std::uint32_t layer = first->layer;
            const auto end = std::find_if(first, items.end(),
                                          [&](const Item& item) { return item.layer != layer; });
            in_layer(layer, [&] { std::for_each(first, end, draw); });
            first = end;
        }
    }

    /// Calls `draw` in each pass of the layer, and of the layers around it.
    void in_layer(std::uint32_t layer, const std::function<void()>& draw) {
        if (layer == 0) return draw();
        const Layer& l = layers_[layer - 1];
        in_layer(l.outer, [&] {
            for (int pass = 0; pass < most_passes; ++pass) {
                const Node* node = instances_.nodes.find(l.self);
                if (node == nullptr) return;
                const Lifecycle& lifecycle = instances_.class_of(*node).lifecycle();
                if (!lifecycle.begin_below(lifecycle.context, tree_, l.self, node->row, painter_,
                                           pass))
                    return;
                draw();
                node = instances_.nodes.find(l.self);
                lifecycle.end_below(lifecycle.context, tree_, l.self,
                                    node == nullptr ? 0 : node->row, painter_);
            }
        });
    }

    static constexpr int most_passes = 10'000;
    /// `z` is the first property that the tree stores, in every class.
    static constexpr std::uint32_t z_index = 0;

    const Tree& tree_;
    const Instances& instances_;
    Painter& painter_;
    double alpha_;
    Drawer* also_;
    std::size_t pushed_before_ = painter_.pushed();
    std::vector<Kind> kinds_;
    bool depends_on_above_ = false;
    std::vector<Level> levels_;
    std::vector<Layer> layers_;
    std::vector<Item> drawn_, over_;
};

}  // namespace

Drawing::Drawing(double alpha)
    : before_(std::exchange(drawn_alpha, std::clamp(alpha, 0.0, 1.0))),
      outer_(std::exchange(drawing_now, true)) {}

Drawing::~Drawing() {
    drawn_alpha = before_;
    drawing_now = outer_;
}

DrawingPart::DrawingPart(Part part) : before_(std::exchange(drawn_part, part)) {}

DrawingPart::~DrawingPart() {
    drawn_part = before_;
}

double Drawing::alpha() {
    return drawn_alpha;
}

bool Drawing::underway() {
    return drawing_now;
}

void Tree::draw(Handle top, Painter& painter, double alpha, Drawer* also) const {
    const State& s = *state_;
    s.instances.require(top);
    const Drawing drawing(alpha);
    const Pin pin(state_->lifetime, "a lifecycle function");
    Sheet sheet(*this, s.instances, painter, alpha, also);
    sheet.collect(top.index);
    try {
        sheet.draw();
    } catch (...) {
        sheet.abandon();
        throw;
    }
}

}  // namespace fettle::property
