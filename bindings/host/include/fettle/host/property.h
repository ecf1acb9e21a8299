/* Values of properties, by path and by handle. A path is convenient; a handle finds its property
 * once, and reading a number by it takes some nanoseconds. */

#pragma once

#include <fettle/host/value.h>

FETTLE_HOST_BEGIN

/** The value at a path: a property ("world.ball.mass"), a component of it
    ("world.ball.position.x") or an element of it ("world.ball.shape.vertices[2]"). */
fettle_code fettle_hosted_get(fettle_hosted* game, const char* path, fettle_hosted_value* value);
fettle_code fettle_hosted_set(fettle_hosted* game, const char* path,
                              const fettle_hosted_value* value);

/** Removes the value that was set: the property has its default again, or the value that the module
 * computes. */
fettle_code fettle_hosted_reset(fettle_hosted* game, const char* path);

/** A handle of a property of an instance, or of a component of one; 0 is none. It uses memory until
    it is released. After its instance is deleted, its functions give FETTLE_STALE. */
typedef uint64_t fettle_property_id;

/** Handles by path, or by instance and name; `release` ends one. */
fettle_code fettle_property_at(fettle_hosted* game, const char* path, fettle_property_id* property);
fettle_code fettle_property_of(fettle_hosted* game, fettle_instance instance, const char* name,
                               fettle_property_id* property);
fettle_code fettle_property_release(fettle_hosted* game, fettle_property_id property);

/** The value of the property. */
fettle_code fettle_property_get(fettle_hosted* game, fettle_property_id property,
                                fettle_hosted_value* value);
fettle_code fettle_property_set(fettle_hosted* game, fettle_property_id property,
                                const fettle_hosted_value* value);

/** The same for one type. A getter refuses a value of another type, except that an integer is a
   number too. */
fettle_code fettle_property_get_number(fettle_hosted* game, fettle_property_id property,
                                       double* number);
fettle_code fettle_property_set_number(fettle_hosted* game, fettle_property_id property,
                                       double number);
fettle_code fettle_property_get_boolean(fettle_hosted* game, fettle_property_id property,
                                        bool* boolean);
fettle_code fettle_property_set_boolean(fettle_hosted* game, fettle_property_id property,
                                        bool boolean);
fettle_code fettle_property_get_vec2(fettle_hosted* game, fettle_property_id property, double* x,
                                     double* y);
fettle_code fettle_property_set_vec2(fettle_hosted* game, fettle_property_id property, double x,
                                     double y);
fettle_code fettle_property_get_text(fettle_hosted* game, fettle_property_id property,
                                     const char** text);
fettle_code fettle_property_set_text(fettle_hosted* game, fettle_property_id property,
                                     const char* text);
fettle_code fettle_property_get_instance(fettle_hosted* game, fettle_property_id property,
                                         fettle_instance* instance);
fettle_code fettle_property_set_instance(fettle_hosted* game, fettle_property_id property,
                                         fettle_instance instance);

FETTLE_HOST_END
