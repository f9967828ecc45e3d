# SPDX-License-Identifier: MIT
#
# The boards that QEMU emulates, and what a program needs to run on one.  The
# addresses are those of QEMU 7.2's machines; where there is a larger memory
# beside the core's own RAM, it is the one used, for the tests' sake.
#
# ocel_board(<name> <code origin> <size> <ram origin> <size> <stack> <SysTick Hz>)
set(OCEL_BOARDS "")
function(ocel_board name code_origin code_size ram_origin ram_size stack_size systick_hz)
  set(OCEL_BOARDS ${OCEL_BOARDS} ${name} PARENT_SCOPE)
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/arm/board.ld.in"
                 "${PROJECT_BINARY_DIR}/port/${name}.ld" @ONLY)
  set("OCEL_SYSTICK_HZ_${name}" ${systick_hz} PARENT_SCOPE)
endfunction()

ocel_board(microbit   0x00000000 256K 0x20000000  16K   2K 16000000)
ocel_board(mps2-an385 0x00000000   4M 0x21000000  16M 256K 25000000)
ocel_board(mps2-an386 0x00000000   4M 0x21000000  16M 256K 25000000)
ocel_board(mps2-an500 0x00000000   4M 0x60000000  16M 256K 25000000)
ocel_board(mps2-an505 0x10000000   4M 0x80000000  16M 256K 20000000)
ocel_board(mps3-an547 0x00000000 512K 0x60000000  16M 256K 32000000)

set(ocel_port_dir "${CMAKE_CURRENT_LIST_DIR}")
set(ocel_qemu_quiet -display none -monitor none -serial null -chardev stdio,id=text
    -semihosting-config enable=on,target=native,chardev=text)

# ocel_on_board(<target> [BOARD name] [BARE] [COUNTED]) makes an executable one that runs on
# the board: port and startup linked in, and QEMU the way to run it, so that
# add_test(COMMAND target) runs it there.  BARE leaves the C library's stdio out.
# COUNTED has QEMU count, so that the port's counter is exact: on Arm every instruction
# takes 128 ns of the board's time, and on RISC-V one tick, which is what QEMU's minstret
# counts.  BOARD is OCEL_BOARD unless given.
function(ocel_on_board target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "BARE;COUNTED" "BOARD" "")
  if(NOT arg_BOARD)
    set(arg_BOARD "${OCEL_BOARD}")
  endif()
  set(quiet ${ocel_qemu_quiet})
  if(arg_COUNTED AND arg_BOARD STREQUAL "virt")
    list(APPEND quiet -icount shift=0,sleep=off)
  elseif(arg_COUNTED)
    list(APPEND quiet -icount shift=7,sleep=off)
  endif()
  target_include_directories(${target} PRIVATE "${ocel_port_dir}")
  if(arg_BOARD STREQUAL "virt")
    target_sources(${target} PRIVATE "${ocel_port_dir}/riscv/port.c")
    target_link_options(${target} PRIVATE --oslib=semihost --crt0=semihost
      LINKER:--defsym=__flash=0x80000000,--defsym=__flash_size=4M
      LINKER:--defsym=__ram=0x80400000,--defsym=__ram_size=64M,--defsym=__stack_size=256K)
    set_target_properties(${target} PROPERTIES CROSSCOMPILING_EMULATOR
      "qemu-system-riscv32;-M;virt;-bios;none;${quiet};-kernel")
    return()
  endif()
  if(NOT arg_BOARD IN_LIST OCEL_BOARDS)
    message(FATAL_ERROR "No board '${arg_BOARD}'; port/boards.cmake has ${OCEL_BOARDS} virt")
  endif()
  target_sources(${target} PRIVATE "${ocel_port_dir}/arm/port.c" "${ocel_port_dir}/arm/startup.c")
  target_compile_definitions(${target} PRIVATE
    "OCEL_PORT_SYSTICK_HZ=${OCEL_SYSTICK_HZ_${arg_BOARD}}U"
    "OCEL_PORT_STDIO=$<NOT:$<BOOL:${arg_BARE}>>")
  target_link_options(${target} PRIVATE -nostartfiles LINKER:--gc-sections
    -T "${PROJECT_BINARY_DIR}/port/${arg_BOARD}.ld"
    --specs=$<IF:$<BOOL:${arg_BARE}>,nosys.specs,rdimon.specs>)
  set_target_properties(${target} PROPERTIES
    LINK_DEPENDS "${PROJECT_BINARY_DIR}/port/${arg_BOARD}.ld"
    CROSSCOMPILING_EMULATOR "qemu-system-arm;-M;${arg_BOARD};${quiet};-kernel")
endfunction()
