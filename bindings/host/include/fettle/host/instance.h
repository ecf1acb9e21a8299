/* Instances of the tree and their classes. Names and paths are those of the console: "world.ball".
 */

#pragma once

#include <fettle/host/value.h>

FETTLE_HOST_BEGIN

/** The instance with that path; "game" is the root. */
fettle_code fettle_hosted_find(fettle_hosted* game, const char* path, fettle_instance* found);

/** False for 0, for a deleted instance, if the game is null or destroyed, and in another thread. */
bool fettle_hosted_is_alive(const fettle_hosted* game, fettle_instance instance);

/** A new instance below `parent` (0: detached, not simulated). A null name: one is made. `made` may
    be null. */
fettle_code fettle_hosted_make(fettle_hosted* game, const char* class_name, fettle_instance parent,
                               const char* name, fettle_instance* made);

/** Deletes the instance and all below it. */
fettle_code fettle_hosted_delete(fettle_hosted* game, fettle_instance instance);

/** Gives the instance another parent (0: detaches it), and a name unless that is null. */
fettle_code fettle_hosted_move(fettle_hosted* game, fettle_instance instance,
                               fettle_instance parent, const char* name);

/** 0 for the root and for a detached instance. */
fettle_code fettle_hosted_parent(fettle_hosted* game, fettle_instance instance,
                                 fettle_instance* parent);

/** 0 if there is none of that name. */
fettle_code fettle_hosted_child(fettle_hosted* game, fettle_instance instance, const char* name,
                                fettle_instance* child);

/** The children in order. A list: see fettle/physics_c/basics.h. */
fettle_code fettle_hosted_children(fettle_hosted* game, fettle_instance instance,
                                   fettle_instance* out, uint32_t room, uint32_t* count);

/** Its name among its siblings, and its path from the root. */
fettle_code fettle_hosted_name(fettle_hosted* game, fettle_instance instance, const char** name);
fettle_code fettle_hosted_path(fettle_hosted* game, fettle_instance instance, const char** path);

/** Name of the class, which lives as long as the game. */
fettle_code fettle_hosted_class_of(fettle_hosted* game, fettle_instance instance,
                                   const char** class_name);

/** Whether the class of the instance is `class_name` or derives from it. */
fettle_code fettle_hosted_is_a(fettle_hosted* game, fettle_instance instance,
                               const char* class_name, bool* is_a);

/** Names of all classes in the order of their definition. They live as long as the game. A list. */
fettle_code fettle_hosted_classes(fettle_hosted* game, const char** out, uint32_t room,
                                  uint32_t* count);

/** A member of a class. Its texts live as long as the game. */
typedef struct fettle_member {
    const char* name;        /* as in Lua */
    const char* doc;         /* "" without one */
    const char* unit;        /* of a property; "" without a unit */
    const char* declared_by; /* the class, or one that it derives from */
    int32_t kind;            /* one of fettle_member_kind */
    int32_t type;            /* of a property: one of fettle_value_type */
    bool read_only;          /* of a property */
} fettle_member;

/** What a member of a class is. */
enum fettle_member_kind {
    FETTLE_MEMBER_PROPERTY = 0,
    FETTLE_MEMBER_METHOD = 1,
    FETTLE_MEMBER_EVENT = 2
};

/** Properties, methods and events of a class, those of its bases included. A list. */
fettle_code fettle_hosted_members(fettle_hosted* game, const char* class_name, fettle_member* out,
                                  uint32_t room, uint32_t* count);

/** Calls a method of the instance. `arguments` may be null if `count` is 0, and `result` may be
    null. A result with named fields is a list of their values, in the order of the method's
    description; several of them are a list of such lists. */
fettle_code fettle_hosted_call_method(fettle_hosted* game, fettle_instance instance,
                                      const char* method, const fettle_hosted_value* arguments,
                                      uint32_t count, fettle_hosted_value* result);

FETTLE_HOST_END
