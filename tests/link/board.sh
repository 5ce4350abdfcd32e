# The board that stands for a CPU in QEMU; sourced by the scripts beside it.

# board CPU
board() {
    case $1 in
    cortex-m0plus) echo microbit ;;
    *) echo mps2-an386 ;;
    esac
}

# run_on_board CPU ELF : what the program writes
run_on_board() {
    timeout 60 qemu-system-arm -M "$(board "$1")" -display none \
        -monitor none -serial none -chardev stdio,id=out \
        -semihosting-config enable=on,target=native,chardev=out \
        -kernel "$2" </dev/null
}
