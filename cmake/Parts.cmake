# Which parts there are, which of them are to be built, and what each rests on.
#
# A project that takes Fettle in as a folder of its own gets the parts that need nothing but Eigen, and names
# more in FETTLE_PARTS when it wants them:
#
#   set(FETTLE_PARTS physics)            only rigid bodies
#   set(FETTLE_PARTS physics console)    and everything the console rests on

set(fettle_parts property storage maps physics module physics_module script app console fettle)
set(fettle_needs_property)
set(fettle_needs_storage property)
set(fettle_needs_maps property)
set(fettle_needs_physics)
set(fettle_needs_module property)
set(fettle_needs_physics_module module property physics)
set(fettle_needs_script property storage)
set(fettle_needs_app script property)
set(fettle_needs_console app script storage property)
set(fettle_needs_fettle ${fettle_parts})

set(fettle_folder_property framework/property)
set(fettle_folder_maps framework/maps)
set(fettle_folder_physics physics)
set(fettle_folder_module framework/module)
set(fettle_folder_physics_module physics/module)
set(fettle_folder_script framework/script)
set(fettle_folder_app framework/app)
set(fettle_folder_console console)
set(fettle_folder_fettle fettle)

if(PROJECT_IS_TOP_LEVEL)
  set(fettle_default_parts "${fettle_parts}")
else()
  set(fettle_default_parts property physics module physics_module)
endif()
set(FETTLE_PARTS "${fettle_default_parts}" CACHE STRING "The parts to build, with all that they rest on: ${fettle_parts}")

# With what the named ones rest on, in the order they are to be built in.
function(fettle_close_over_needs)
  set(wanted ${FETTLE_PARTS})
  set(open ${FETTLE_PARTS})
  while(open)
    list(POP_FRONT open part)
    if(NOT part IN_LIST fettle_parts)
      string(JOIN ", " known ${fettle_parts})
      message(FATAL_ERROR "FETTLE_PARTS names \"${part}\"; there are ${known}")
    endif()
    foreach(need IN LISTS fettle_needs_${part})
      if(NOT need IN_LIST wanted)
        list(APPEND wanted ${need})
        list(APPEND open ${need})
      endif()
    endforeach()
  endwhile()
  set(ordered)
  foreach(part IN LISTS fettle_parts)
    if(part IN_LIST wanted)
      list(APPEND ordered ${part})
    endif()
  endforeach()
  set(FETTLE_PARTS "${ordered}" PARENT_SCOPE)
endfunction()
fettle_close_over_needs()
