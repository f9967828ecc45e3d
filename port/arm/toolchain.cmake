# SPDX-License-Identifier: MIT
#
# Cross-compiling for Cortex-M with arm-none-eabi-gcc.  OCEL_ARM_CPU is the
# list of flags that name the core, for example "-mcpu=cortex-m4;-mfloat-abi=soft".
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)

set(OCEL_ARM_CPU "-mcpu=cortex-m0" CACHE STRING "Flags that name the core")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES OCEL_ARM_CPU)
add_compile_options(${OCEL_ARM_CPU} -mthumb -ffunction-sections -fdata-sections)
add_link_options(${OCEL_ARM_CPU} -mthumb)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
