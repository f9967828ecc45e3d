# SPDX-License-Identifier: MIT
#
# Cross-compiling for RISC-V with Debian's riscv64-unknown-elf-gcc and picolibc.
# OCEL_RISCV_CPU is the list of flags that name the core.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)

set(OCEL_RISCV_CPU "-march=rv32imac;-mabi=ilp32" CACHE STRING "Flags that name the core")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES OCEL_RISCV_CPU)
add_compile_options(${OCEL_RISCV_CPU} --specs=picolibc.specs -ffunction-sections -fdata-sections)
add_link_options(${OCEL_RISCV_CPU} --specs=picolibc.specs)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
