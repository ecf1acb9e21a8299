#include <cstdlib>
#include <cstring>
#include <new>

#include <limits/arena.h>
#include <lua/lua_api.h>

namespace fettle::script {

void* Arena::allocate_block(std::size_t size) {
    if (size > small) return std::malloc(size);
    const std::size_t list = list_of(size);
    if (Free* block = lists_[list]) {
        lists_[list] = block->next;
        return block;
    }
    const std::size_t rounded = list * granule;
    if (fresh_left_ < rounded) {
        // The rest of the old chunk is used for smaller blocks.
        if (fresh_left_ >= granule) {
            free_block(fresh_, fresh_left_ / granule * granule);
            fresh_left_ = 0;
        }
        try {
            chunks_.push_back(std::make_unique<std::byte[]>(chunk_bytes));
        } catch (const std::bad_alloc&) {
            return nullptr;
        }
        fresh_ = chunks_.back().get();
        fresh_left_ = chunk_bytes;
    }
    void* block = fresh_;
    fresh_ += rounded;
    fresh_left_ -= rounded;
    return block;
}

void Arena::free_block(void* block, std::size_t size) {
    if (size > small) {
        std::free(block);
        return;
    }
    free_small(block, size);
}

bool Arena::refuse(std::size_t growth, std::size_t size) {
    if (growth <= limit_ && bytes_ <= limit_ - growth) return false;
    return report_refusal(size, false);
}

// After a refusal, Lua makes a full collection and requests the same size again. Only the second
// refusal is final.
bool Arena::report_refusal(std::size_t size, bool by_system, bool text) {
    const bool final = refused_ == size;
    refused_ = final ? 0 : size;
    return !on_refusal ||
           on_refusal({.size = size, .by_system = by_system, .final = final, .text = text});
}

void* Arena::allocate(void* user, void* block, std::size_t old_size, std::size_t new_size) {
    auto& arena = *static_cast<Arena*>(user);
    // The common cases first: allocating and freeing a small object.
    if (!block) {
        if (new_size - 1 < small && arena.bytes_ + new_size <= arena.limit_) {
            Free*& head = arena.lists_[list_of(new_size)];
            if (Free* taken = head) {
                head = taken->next;
                arena.bytes_ += new_size;
                arena.refused_ = 0;
                return taken;
            }
        }
        // The kind of the object; Lua keeps short texts in blocks of a few bytes.
        if (old_size == LUA_TSTRING && arena.longest_text_ != 0 &&
            new_size > arena.longest_text_ + large && arena.report_refusal(new_size, false, true))
            return nullptr;
        old_size = 0;  // for a new object, Lua passes its kind instead of a size
    } else if (new_size == 0 && old_size <= small) {
        arena.free_small(block, old_size);
        arena.bytes_ -= old_size;
        return nullptr;
    }
    if (new_size == 0) {
        if (block) arena.free_block(block, old_size);
        arena.bytes_ -= old_size;
        return nullptr;
    }
    if (new_size > old_size) {
        if (arena.refuse(new_size - old_size, new_size)) return nullptr;
        if (new_size >= large && arena.on_large) arena.on_large(new_size);
    }
    void* result;
    if (block && old_size > small && new_size > small) {
        result = std::realloc(block, new_size);
        if (!result && new_size <= old_size) return block;
        if (!result) {
            arena.report_refusal(new_size, true);
            return nullptr;
        }
    } else if (block && list_of(old_size) == list_of(new_size) && new_size <= small) {
        result = block;
    } else {
        result = arena.allocate_block(new_size);
        if (!result) {
            // Lua requires that shrinking never fails.
            if (block && new_size <= old_size) return block;
            arena.report_refusal(new_size, true);
            return nullptr;
        }
        if (block) {
            std::memcpy(result, block, old_size < new_size ? old_size : new_size);
            arena.free_block(block, old_size);
        }
    }
    arena.bytes_ += new_size;
    arena.bytes_ -= old_size;
    // Not if a table shrinks, which a collection may do between the two requests.
    if (new_size > old_size) arena.refused_ = 0;
    return result;
}

}  // namespace fettle::script
