#!/usr/bin/perl
# Doxygen reads every header through this filter, which makes comments of the house style comments of Doxygen:
#
#   C    The first comment describes the file. A comment behind a member describes it. Functions without an empty line between them share the comment before the
#        first one. A member `size` is described here. Members that are declared together share the comment behind them.
#   C++  A comment behind a member describes it. A setter directly behind its getter shares the getter's comment, and so does an overload directly behind a function
#        of the same name. Defaulted comparisons, and the protected members, from which only the library derives, need no
#        comment.
#
# Everything else needs a comment of its own: warnings are errors when the reference is built.
use strict;
use warnings;

# The comments for Doxygen in front of a declaration that has none of its own: those of the one before.
sub with_shared_comments {
    my ($is_shared, @lines) = @_;
    my ($comment, $shared, $name, $text, $out) = ('', '', '', '', '');
    my $finish = sub {
        return if $text eq '';
        my ($declared) = $text =~ /(\(\*[a-z_0-9]+\)|[a-z_0-9]+|operator[-+*\/]=?)\(/;
        $declared =~ s/operator.*/operator/ if defined $declared;
        my $own = $comment;
        $own .= "/// $1\n" while $text =~ m{///< (.*)}g;
        if (defined $declared && $own eq '' && $shared ne '' && $is_shared->($name, $declared)) {
            (my $before = $shared) =~ s{^\s*///?\s*|\s*/?\*\*?/?\s*|\n}{ }mg;
            $out .= "/** $before */ ";
        } else {
            $shared = $own;
        }
        $name = $declared // '';
        $out .= $comment . $text;
        ($comment, $text) = ('', '');
    };
    my ($whole, $in_comment) = (1, 0);
    for my $line (@lines) {
        if ($in_comment || ($whole && $line =~ m{^\s*(///(?!<)|/\*\*)})) {
            $finish->() unless $in_comment;
            $comment .= $line;
            $in_comment = $line =~ m{^\s*///} ? 0 : $line !~ m{\*/};
        } elsif ($line =~ m{^\s*$|^/\* .*\*/$}) {
            $finish->();
            $out .= $comment . $line;
            ($comment, $shared, $name) = ('', '', '');
        } else {
            $finish->() if $whole && $line !~ m{^\s*///<};
            $text .= $line;
            (my $code = $line) =~ s{\s*//.*}{};
            $whole = $code =~ /[;{}:>]$|^#|^[A-Z_]+$/ if $code =~ /\S/;
        }
    }
    $finish->();
    return $out . $comment;
}

sub c_header {
    my $inside = 0;
    my ($name, @lines) = @_;
    $lines[0] =~ s{^/\*\*? }{/** \\file $name };
    for (@lines) {
        s{^(enum \{) +/\* (.*?) \*/$}{/** $2 */ $1};
        s{^/\* (?=[^-])}{/** };
        $inside = 1 if m{^(?:/\*\* .* )?(?:typedef )?(?:struct|enum|union)(?: [a-z_0-9]+)? \{};
        $inside = 0 if /^\}/;
        next unless $inside;
        s{^(    uint32_t size;)$}{$1 /**< Of the structure, bytes; the function ..._init writes it. */};
        s{^(    \S.*) /\* }{$1 /**< };
        s{^    /\* }{    /** };
        # Each of several members gets the comment behind them.
        if (m{^    ([^(,*]+) (\w+(?:, \w+)+);\s*(/\*\*<.*\*/)?$}) {
            my ($type, $names, $comment) = ($1, $2, $3 // '');
            $_ = '    ' . join(' ', map { "$type $_; $comment" } split /, /, $names) . "\n";
        }
    }
    my $text = join '', @lines;
    my $out = '';
    # Only functions share comments, not the members of structures.
    for my $part (split /(^(?:typedef )?(?:struct|enum|union)(?: [a-z_0-9]+)? \{.*?^\}[^\n]*\n)/ms, $text) {
        $out .= $part =~ /^(?:typedef )?(?:struct|enum|union)(?: [a-z_0-9]+)? \{/ ? $part
            : with_shared_comments(sub { 1 }, $part =~ /^.*\n?/mg);
    }
    return $out;
}

sub cpp_header {
    my $text = join '', @_;
    $text =~ s{^(template <>\n(?:struct std::hash.*?^\};|[^;]*;))}{/** \\cond */ $1 /** \\endcond */}gms;
    my @lines = $text =~ /^.*\n?/mg;
    my $hidden = 0;
    for (@lines) {
        if (/^  (?:private|public):|^\};/ && $hidden) { $hidden = 0; $_ = "/** \\endcond */ $_" }
        if (/^  protected:/) { $hidden = 1; s{$}{ /** \\cond */} }
        s{^( *)(.*operator(?:==|<=>)\(.*= default;)}{$1/** Compares all members. */ $2};
        s!^(\s*[^\s/#}].*[;,}]) +// (?\!NOLINT)!$1  ///< !;
        # Each of several members gets the comment behind them.
        if (m{^    ([\w:<>]+) (\w+(?: = [^,;]+|\{[^\}]*\})?(?:, \w+(?: = [^,;]+|\{[^\}]*\})?)+);\s*(///< .*)$}) {
            my ($type, $names, $comment) = ($1, $2, $3);
            $comment =~ s{///< (.*)}{/**< $1 */};
            $names =~ s/\{[^\}]*\}//g;
            $_ = '    ' . join(' ', map { "$type $_; $comment" } split /, /, $names) . "\n";
        }
        s{using (\w+)::\1;}{};  # constructors, as in the base class
    }
    return with_shared_comments(sub { $_[1] eq $_[0] || $_[1] eq "set_$_[0]" }, @lines);
}

my ($file) = @ARGV;
open my $in, '<:encoding(UTF-8)', $file or die "$file: $!\n";
binmode STDOUT, ':encoding(UTF-8)';
my @lines = <$in>;
print $file =~ m{/physics_c/|/host/|/abi\.h$|/fettle_(?:physics|host)\.h$} ? c_header($file =~ m{include/(.*)}, @lines) : cpp_header(@lines);
