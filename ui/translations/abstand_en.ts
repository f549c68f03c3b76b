<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>abstand::studio::Studio</name>
    <message numerus="yes">
        <source>open %n files</source>
        <translation>
            <numerusform>open %n file</numerusform>
            <numerusform>open %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui</name>
    <message numerus="yes">
        <source>%n unchecked pairs left out</source>
        <translation>
            <numerusform>%n unchecked pair left out</numerusform>
            <numerusform>%n unchecked pairs left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of people and robots are not checked, and are not part of it.</source>
        <translation>
            <numerusform>%n pair of a person and a robot is not checked, and is not part of it.</numerusform>
            <numerusform>%n pairs of people and robots are not checked, and are not part of it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stops, %1 % of the time; %2 false, %3 missed</source>
        <translation>
            <numerusform>%n stop, %1 % of the time; %2 false, %3 missed</numerusform>
            <numerusform>%n stops, %1 % of the time; %2 false, %3 missed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::MainWindow</name>
    <message numerus="yes">
        <source>The project has settings for %n names that the scene does not have. They have no effect:
%1</source>
        <translation>
            <numerusform>The project has settings for %n name that the scene does not have. It has no effect:
%1</numerusform>
            <numerusform>The project has settings for %n names that the scene does not have. They have no effect:
%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginCommands</name>
    <message numerus="yes">
        <source>margins of %n objects</source>
        <translation>
            <numerusform>margin of %n object</numerusform>
            <numerusform>margins of %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n locked margins stay as they are</source>
        <translation>
            <numerusform>%n locked margin stays as it is</numerusform>
            <numerusform>%n locked margins stay as they are</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n margins</source>
        <translation>
            <numerusform>%n margin</numerusform>
            <numerusform>%n margins</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::ReactionPanel</name>
    <message numerus="yes">
        <source>%n differences from the scene file</source>
        <translation>
            <numerusform>%n difference from the scene file</numerusform>
            <numerusform>%n differences from the scene file</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::RecordingPanel</name>
    <message numerus="yes">
        <source>%1 s, %n frames</source>
        <translation>
            <numerusform>%1 s, %n frame</numerusform>
            <numerusform>%1 s, %n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>cut: %n frames at least are missing or not complete</source>
        <translation>
            <numerusform>cut: %n frame at least is missing or not complete</numerusform>
            <numerusform>cut: %n frames at least are missing or not complete</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frames lack a joint</source>
        <translation>
            <numerusform>%n frame lacks a joint</numerusform>
            <numerusform>%n frames lack a joint</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::SceneEdits</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::VerificationDialog</name>
    <message numerus="yes">
        <source>⚠ %n breaches</source>
        <translation>
            <numerusform>⚠ %n breach</numerusform>
            <numerusform>⚠ %n breaches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Passed: all %n checks.</source>
        <translation>
            <numerusform>Passed: %n check.</numerusform>
            <numerusform>Passed: all %n checks.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not passed: %1 of %n checks.</source>
        <translation>
            <numerusform>Not passed: %1 of %n check.</numerusform>
            <numerusform>Not passed: %1 of %n checks.</numerusform>
        </translation>
    </message>
</context>
</TS>
