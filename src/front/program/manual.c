/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the manual page and the completion of the shell. Read commands.h first. */
#include "front/program/commands.h"
#include "front/program/command.h"
#include "base/version.h"
#include <string.h>

/* Prints text for man: a minus is a minus, and no line begins with a dot or a quote. */
static void put(FILE *out, const char *text) {
    for (; *text; text++) {
        if (*text == '-' || *text == '\\')
            fputc('\\', out);
        fputc(*text == '\\' ? 'e' : *text, out);
    }
}

static void put_command(FILE *out, const struct command *command) {
    fprintf(out, ".SS scree %s ", command->name);
    put(out, command->arguments);
    fprintf(out, "\n\\&");
    put(out, command->summary);
    fprintf(out, ".\n");
    const struct flag *flag;
    for (int k = 0; (flag = command_line_flag(command, k)) != NULL; k++) {
        fprintf(out, ".TP\n.B \\-\\-");
        put(out, flag->name);
        if (flag->argument) {
            fprintf(out, " \\fI");
            put(out, flag->argument);
            fprintf(out, "\\fR");
        }
        fprintf(out, "\n\\&");
        put(out, flag->help);
        fprintf(out, ".\n");
    }
}

void manual_page(FILE *out) {
    const struct command *command;
    fprintf(out, ".\\\" Made by: scree help --man\n.TH SCREE 1 \"\" \"scree %s\" \"User Commands\"\n",
            version_number());
    fprintf(out, ".SH NAME\nscree \\- simulates particles of very different sizes\n.SH SYNOPSIS\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++) {
        fprintf(out, "%s.B scree %s\n\\&", k ? ".br\n" : "", command->name);
        put(out, command->arguments);
        fprintf(out, " [\\fIFLAG\\fR ...]\n");
    }
    fprintf(out, ".br\n.B scree help\n[\\fICOMMAND\\fR | \\fIKEY\\fR]\n.br\n.B scree \\-\\-version\n");
    fprintf(out, ".SH DESCRIPTION\n"
                 "A scene is a YAML file. \\fBscree help\\fR lists the keys of a scene, and \\fBscree help "
                 "\\fIKEY\\fR explains one of them.\n"
                 "Several ranks: \\fBmpirun \\-n 4 scree run\\fR ...\n"
                 ".SH COMMANDS\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++)
        put_command(out, command);
    fprintf(out,
            ".SH EXIT STATUS\n"
            "0: all is well. 1: MPI, HDF5, memory or disk failed. 2: a mistake in the scene, a file or the "
            "command line. 3: a guard stopped the run. 128 and the number of a signal: the signal ended the "
            "run, after a checkpoint.\n"
            ".SH ENVIRONMENT\n.TP\n.B OMP_NUM_THREADS\nthreads of a rank, if the scene does not say.\n");
}

void manual_bash(FILE *out) {
    const struct command *command;
    const struct flag *flag;
    fprintf(out, "# Made by: scree help --bash\n"
                 "_scree() {\n"
                 "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=\n"
                 "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
                 "        words=\"");
    for (int k = 0; (command = command_get(k)) != NULL; k++)
        fprintf(out, "%s ", command->name);
    fprintf(out, "help --version\"\n"
                 "    else\n"
                 "        case ${COMP_WORDS[1]} in\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++) {
        fprintf(out, "        %s) words=\"", command->name);
        for (int f = 0; (flag = command_line_flag(command, f)) != NULL; f++)
            fprintf(out, "--%s ", flag->name);
        fprintf(out, "--help\" ;;\n");
    }
    fprintf(out, "        help) words=\"");
    for (int k = 0; (command = command_get(k)) != NULL; k++)
        fprintf(out, "%s ", command->name);
    fprintf(out, "\" ;;\n"
                 "        esac\n"
                 "        case $before in\n"
                 "        --set) words=$(scree help 2>/dev/null | sed -n "
                 "'s/^\\([a-z_]*\\(\\[N\\]\\)*[a-z_.]*\\)  .*/\\1=/p') ;;\n"
                 "        --row) words='first last' ;;\n"
                 "        esac\n"
                 "    fi\n"
                 "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
                 "    [[ $word == -* || $COMP_CWORD == 1 ]] || COMPREPLY+=($(compgen -f -- \"$word\"))\n"
                 "}\n"
                 "complete -o filenames -F _scree scree\n");
}

/* Prints the first sentence of a text with a backslash before each of the characters in `quoted`, and a single quote as
 * `quote`. */
static void put_quoted(FILE *out, const char *text, const char *quoted, const char *quote) {
    for (; *text && *text != ';'; text++) {
        if (*text == '\'') {
            fputs(quote, out);
            continue;
        }
        if (strchr(quoted, *text))
            fputc('\\', out);
        fputc(*text, out);
    }
}

void manual_zsh(FILE *out) {
    const struct command *command;
    const struct flag *flag;
    fprintf(
        out,
        "#compdef scree\n# Made by: scree help --zsh\n_scree() {\n    local -a commands\n    commands=(\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++) {
        fprintf(out, "        '%s:", command->name);
        put_quoted(out, command->summary, "", "'\\''");
        fprintf(out, "'\n");
    }
    fprintf(out,
            "        'help:a command at length, all keys of a scene, or one key at length'\n    )\n"
            "    if (( CURRENT == 2 )); then\n        _describe command commands\n        return\n    fi\n"
            "    case $words[2] in\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++) {
        fprintf(out, "    %s)\n        _arguments '*:file:_files'", command->name);
        for (int f = 0; (flag = command_line_flag(command, f)) != NULL; f++) {
            fprintf(out, " \\\n            '%s--%s[", strcmp(flag->name, "set") == 0 ? "*" : "", flag->name);
            put_quoted(out, flag->help, "[]:\\", "'\\''");
            fprintf(out, "]");
            if (flag->argument) {
                fprintf(out, ":");
                put_quoted(out, flag->argument, ":\\", "'\\''");
                fprintf(out, ":_files");
            }
            fprintf(out, "'");
        }
        fprintf(out, " ;;\n");
    }
    fprintf(out, "    help) _describe command commands ;;\n    esac\n}\n_scree \"$@\"\n");
}

void manual_fish(FILE *out) {
    const struct command *command;
    const struct flag *flag;
    fprintf(out, "# Made by: scree help --fish\n");
    for (int k = 0; (command = command_get(k)) != NULL; k++) {
        fprintf(out, "complete -c scree -f -n __fish_use_subcommand -a %s -d '", command->name);
        put_quoted(out, command->summary, "\\", "\\'");
        fprintf(out, "'\n");
        for (int f = 0; (flag = command_line_flag(command, f)) != NULL; f++) {
            fprintf(out, "complete -c scree -n '__fish_seen_subcommand_from %s' -l %s%s -d '", command->name,
                    flag->name, flag->argument ? " -r" : "");
            put_quoted(out, flag->help, "\\", "\\'");
            fprintf(out, "'\n");
        }
    }
    fprintf(out, "complete -c scree -f -n __fish_use_subcommand -a help -d 'a command at length, all keys of "
                 "a scene, or one "
                 "key at length'\n");
}
