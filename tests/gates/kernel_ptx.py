"""The simulation's kernels as PTX, for the oldest architecture we build for and for the one we measure on.

What two gates share: one looks into the PTX, one at what ptxas makes of it. nvcc compiles each file once per
architecture with the project's own flags, into <build>/gates/ptx.
"""
import gate_tools

ARCHITECTURES = ("sm_75", "sm_90")


def ptx_of(command, cache, file, options, architecture):
    """The path of the PTX."""
    kept = [option for option in options if not option.startswith(("--generate-code", "-gencode", "-arch"))]
    words = [command.compiler, *kept, "-x", "cu", "-ptx", f"-arch={architecture}", str(file)]
    return cache.output(words, f"{file} for {architecture}", ".ptx", command.folder)


def any_cuda_command(build):
    """For planted(): a command whose compiler and options stand for all."""
    commands = [c for c in gate_tools.compile_commands(build) if c.is_cuda]
    if not commands:
        raise gate_tools.Skip("this build has no CUDA files (nvcc is missing or GW_CUDA is off)")
    return commands[0]
