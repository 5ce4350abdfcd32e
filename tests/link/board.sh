# The board that stands for a CPU in QEMU; sourced by the scripts beside it.

# board CPU-LEVEL
board() {
    case ${1%-*} in
    cortex-m0plus) echo microbit ;;
    cortex-m4) echo mps2-an386 ;;
    cortex-m7) echo mps2-an500 ;;
    cortex-m33) echo mps2-an505 ;;
    arm926) echo versatilepb ;;
    rv32imc) echo virt -bios none ;;
    lx106) echo sim -cpu lx106 ;;
    esac
}

# run_on_board CPU-LEVEL ELF : what the program writes
run_on_board() {
    arch=arm
    trap='-serial none -chardev stdio,id=out
        -semihosting-config enable=on,target=native,chardev=out'
    case $1 in
    rv32*) arch=riscv32 ;;
    lx106*) arch=xtensa trap=-semihosting ;;
    esac
    QEMU_AUDIO_DRV=none timeout 60 qemu-system-$arch -M $(board "$1") -display none \
        -monitor none $trap -kernel "$2" </dev/null
}
