# SPDX-License-Identifier: MIT
#
# Gives the target ocel_unity: Unity as a package, or its sources from
# UNITY_SOURCE_DIR, or from where tools/setup.sh puts them.
set(UNITY_SOURCE_DIR "" CACHE PATH "Folder with unity.c, unity.h and unity_internals.h")

add_library(ocel_unity INTERFACE)
find_package(unity CONFIG QUIET)
if(TARGET unity::framework)
  target_link_libraries(ocel_unity INTERFACE unity::framework)
else()
  set(ocel_unity_dir "${UNITY_SOURCE_DIR}")
  if(ocel_unity_dir STREQUAL "")
    set(ocel_unity_dir "${PROJECT_SOURCE_DIR}/build/third_party/unity")
  endif()
  if(NOT EXISTS "${ocel_unity_dir}/unity.c")
    message(FATAL_ERROR
      "Unity, the test framework, is not here: no unity.c in ${ocel_unity_dir}.\n"
      "Run 'tools/setup.sh test', which fetches it, "
      "or configure with -DUNITY_SOURCE_DIR=<folder with unity.c>.")
  endif()
  add_library(ocel_unity_sources STATIC "${ocel_unity_dir}/unity.c")
  target_include_directories(ocel_unity_sources SYSTEM PUBLIC "${ocel_unity_dir}")
  target_compile_definitions(ocel_unity_sources PUBLIC UNITY_INCLUDE_DOUBLE UNITY_SUPPORT_64)
  target_link_libraries(ocel_unity INTERFACE ocel_unity_sources)
endif()
