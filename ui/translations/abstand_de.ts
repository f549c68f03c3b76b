<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>DockSet</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Show or hide the scene tree</source>
        <translation>Szenenbaum ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Show or hide the pair table</source>
        <translation>Tabelle der Paare ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Show or hide the timeline</source>
        <translation>Zeitleiste ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Show or hide the plots</source>
        <translation>Diagramme ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Show or hide the margins</source>
        <translation>Sicherheitsabstände ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Show or hide the robots that react</source>
        <translation>Roboter mit Reaktion ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Show or hide the groups of pairs</source>
        <translation>Gruppen von Paaren ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Reservations</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>Show or hide what to know of the scene before believing it</source>
        <translation>Ein- oder ausblenden, was man von der Szene wissen muss, bevor man ihr glaubt</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Show or hide the events of the recording</source>
        <translation>Ereignisse der Aufnahme ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Show or hide the bookmarks</source>
        <translation>Lesezeichen ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Show or hide what was read of the recordings</source>
        <translation>Ein- oder ausblenden, was aus den Aufnahmen gelesen wurde</translation>
    </message>
    <message>
        <source>Margin curve</source>
        <translation>Abstandskurve</translation>
    </message>
    <message>
        <source>Show or hide what the margin of a body part costs</source>
        <translation>Ein- oder ausblenden, was der Sicherheitsabstand eines Körperteils kostet</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Cycle times</source>
        <translation>Zykluszeiten</translation>
    </message>
    <message>
        <source>Show or hide how long the cycles of the loop take</source>
        <translation>Zykluszeiten der Schleife ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Show or hide what is known of the selection</source>
        <translation>Angaben zur Auswahl ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Pair matrix</source>
        <translation>Paarmatrix</translation>
    </message>
    <message>
        <source>Show or hide the matrix of pairs</source>
        <translation>Matrix der Paare ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Schutzabstand</translation>
    </message>
    <message>
        <source>Show or hide protective distances and contact limits of the body parts</source>
        <translation>Schutzabstände und Kontaktgrenzwerte der Körperteile zeigen oder ausblenden</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Show or hide the messages of the window</source>
        <translation>Meldungen des Fensters zeigen oder ausblenden</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Show or hide the edits of the project</source>
        <translation>Änderungen des Projekts zeigen oder ausblenden</translation>
    </message>
    <message>
        <source>Depth image</source>
        <translation>Tiefenbild</translation>
    </message>
    <message>
        <source>Show or hide the depth image with the fitted body</source>
        <translation>Tiefenbild mit dem angepassten Körper zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Regelgesetze</translation>
    </message>
    <message>
        <source>Show or hide the laws of the robots that react</source>
        <translation>Regelgesetze der reagierenden Roboter ein- oder ausblenden</translation>
    </message>
</context>
<context>
    <name>TimePreview</name>
    <message>
        <source>Picture: %1</source>
        <translation>Bild: %1</translation>
    </message>
</context>
<context>
    <name>ViewerPort</name>
    <message>
        <source>The bodies of the scene differ from those of the server.</source>
        <translation>Die Körper der Szene sind andere als die des Servers.</translation>
    </message>
    <message>
        <source>The people of the scene differ from those of the server.</source>
        <translation>Die Personen der Szene sind andere als die des Servers.</translation>
    </message>
    <message>
        <source>The robots of the scene differ from those of the server.</source>
        <translation>Die Roboter der Szene sind andere als die des Servers.</translation>
    </message>
    <message>
        <source>The pairs of the scene differ from those of the server.</source>
        <translation>Die Paare der Szene sind andere als die des Servers.</translation>
    </message>
</context>
<context>
    <name>abstand::studio::LiveCamera</name>
    <message>
        <source>The program &quot;abstand&quot; is neither next to this program nor in PATH.</source>
        <translation>Das Programm „abstand“ liegt weder neben diesem noch im PATH.</translation>
    </message>
    <message>
        <source>Opening the scene…</source>
        <translation>Die Szene wird geöffnet…</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>Warten auf die Kamera…</translation>
    </message>
    <message>
        <source>%1 ended with code %2</source>
        <translation>%1 endete mit dem Code %2</translation>
    </message>
</context>
<context>
    <name>abstand::studio::LiveOpening</name>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>What answers at %1 is no abstand serve of this version.</source>
        <translation>Was unter %1 antwortet, ist kein abstand serve dieser Version.</translation>
    </message>
    <message>
        <source>No answer from %1.

Is abstand serve running there, and does it have a viewer to spare (--viewers)?</source>
        <translation>Keine Antwort von %1.

Läuft dort abstand serve, und hat es noch einen Betrachter frei (--viewers)?</translation>
    </message>
    <message>
        <source>%1 is of the scene %2, which is not here. Give the file of the scene, too.</source>
        <translation>%1 gehört zur Szene %2, die es hier nicht gibt. Geben Sie auch die Datei der Szene an.</translation>
    </message>
</context>
<context>
    <name>abstand::studio::Studio</name>
    <message>
        <source>Cannot open</source>
        <translation>Öffnen nicht möglich</translation>
    </message>
    <message>
        <source>open recording %1</source>
        <translation>Aufnahme %1 öffnen</translation>
    </message>
    <message>
        <source>change the person %1</source>
        <translation>Person %1 ändern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Save range</source>
        <translation>Bereich speichern</translation>
    </message>
    <message>
        <source>pairs of %1</source>
        <translation>Paare aus %1</translation>
    </message>
    <message>
        <source>%1 of %2 pairs of the file are checked here and no longer are</source>
        <translation>%1 von %2 Paaren der Datei werden hier geprüft; das ist nun abgeschaltet</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>%1 cannot be shown with this scene. %2</source>
        <translation>%1 lässt sich mit dieser Szene nicht zeigen. %2</translation>
    </message>
    <message numerus="yes">
        <source>open %n files</source>
        <translation>
            <numerusform>%n Datei öffnen</numerusform>
            <numerusform>%n Dateien öffnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Not opened</source>
        <translation>Nicht geöffnet</translation>
    </message>
    <message>
        <source>%1 has changed and was read again</source>
        <translation>%1 hat sich geändert und wurde neu gelesen</translation>
    </message>
    <message>
        <source>%1 has changed and cannot be read; what is shown stays. %2</source>
        <translation>%1 hat sich geändert und ist nicht lesbar; das Gezeigte bleibt. %2</translation>
    </message>
    <message>
        <source>%1 was placed beside %2: see Inspector, Place</source>
        <translation>%1 steht jetzt neben %2: siehe Inspektor, Ort</translation>
    </message>
    <message>
        <source>%1 was placed in front of %2: see Inspector, Place</source>
        <translation>%1 steht jetzt vor %2: siehe Inspektor, Ort</translation>
    </message>
    <message>
        <source>Open camera file</source>
        <translation>Kameradatei öffnen</translation>
    </message>
    <message>
        <source>The live depth camera ended</source>
        <translation>Die Live-Tiefenkamera wurde beendet</translation>
    </message>
    <message>
        <source>Joint values of robots are received at %1 (UDP)</source>
        <translation>Gelenkwerte von Robotern werden auf %1 (UDP) empfangen</translation>
    </message>
    <message>
        <source>A live depth camera fails</source>
        <translation>Eine Live-Tiefenkamera fällt aus</translation>
    </message>
</context>
<context>
    <name>abstand::studio::TuneProcess</name>
    <message>
        <source>%1 cannot be started</source>
        <translation>%1 kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>The program &quot;abstand&quot; is neither next to this program nor in PATH.</source>
        <translation>Das Programm „abstand“ liegt weder neben diesem noch im PATH.</translation>
    </message>
    <message>
        <source>%1 ended with code %2</source>
        <translation>%1 endete mit dem Code %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui</name>
    <message>
        <source>The window will be in this language when the program is started again</source>
        <translation>Das Fenster erscheint in dieser Sprache, wenn das Programm neu gestartet wird</translation>
    </message>
    <message>
        <source>inside margin</source>
        <translation>Unterschreitung</translation>
    </message>
    <message>
        <source>touch between frames</source>
        <translation>Berührung zwischen Bildern</translation>
    </message>
    <message>
        <source>near miss</source>
        <translation>Annäherung</translation>
    </message>
    <message>
        <source>⚠ missed</source>
        <translation>⚠ verpasst</translation>
    </message>
    <message>
        <source>false</source>
        <translation>Fehlauslösung</translation>
    </message>
    <message>
        <source>%1: not analysed yet</source>
        <translation>%1: noch nicht ausgewertet</translation>
    </message>
    <message>
        <source>inside the margin of %1</source>
        <translation>unter dem Sicherheitsabstand von %1</translation>
    </message>
    <message>
        <source>margin %1</source>
        <translation>Sicherheitsabstand %1</translation>
    </message>
    <message>
        <source>; the pose is lost</source>
        <translation>; die Pose ist verloren</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>Bisher: %1</translation>
    </message>
    <message>
        <source>Analysis: reading files</source>
        <translation>Auswertung: Dateien werden gelesen</translation>
    </message>
    <message>
        <source>Analysis %1 %</source>
        <translation>Auswertung %1 %</translation>
    </message>
    <message>
        <source>⚠ Analysis failed</source>
        <translation>⚠ Auswertung fehlgeschlagen</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>Gegenstände</translation>
    </message>
    <message>
        <source>%1 – %2, %3</source>
        <translation>%1 – %2, %3</translation>
    </message>
    <message>
        <source>Nearest: %1</source>
        <translation>Am nächsten: %1</translation>
    </message>
    <message>
        <source>Person – robot</source>
        <translation>Person – Roboter</translation>
    </message>
    <message>
        <source>Person – thing</source>
        <translation>Person – Gegenstand</translation>
    </message>
    <message>
        <source>Robot – robot</source>
        <translation>Roboter – Roboter</translation>
    </message>
    <message>
        <source>Robot – thing</source>
        <translation>Roboter – Gegenstand</translation>
    </message>
    <message>
        <source>Other pairs</source>
        <translation>Andere Paare</translation>
    </message>
    <message>
        <source>person – robot</source>
        <translation>Person – Roboter</translation>
    </message>
    <message>
        <source>person – thing</source>
        <translation>Person – Gegenstand</translation>
    </message>
    <message>
        <source>robot – robot</source>
        <translation>Roboter – Roboter</translation>
    </message>
    <message>
        <source>robot – thing</source>
        <translation>Roboter – Gegenstand</translation>
    </message>
    <message>
        <source>other pairs</source>
        <translation>andere Paare</translation>
    </message>
    <message>
        <source>Margins are proposed from a recording of a person and a robot; the scene has none.</source>
        <translation>Sicherheitsabstände werden aus der Aufnahme einer Person und eines Roboters vorgeschlagen; die Szene hat keine.</translation>
    </message>
    <message>
        <source>Nothing is proposed, because the analysis of the recording failed: %1</source>
        <translation>Es gibt keinen Vorschlag, weil die Auswertung der Aufnahme fehlgeschlagen ist: %1</translation>
    </message>
    <message>
        <source>Nothing is proposed yet: the analysis of the recording is at %1 %.</source>
        <translation>Es gibt noch keinen Vorschlag: Die Auswertung der Aufnahme ist bei %1 %.</translation>
    </message>
    <message>
        <source>never seen, or never so far away that the robot could have stopped in time; the row stays.</source>
        <translation>nie gesehen oder nie so weit entfernt, dass der Roboter rechtzeitig hätte anhalten können; die Zeile bleibt.</translation>
    </message>
    <message>
        <source>no margin would do; the row stays.</source>
        <translation>kein Sicherheitsabstand würde genügen; die Zeile bleibt.</translation>
    </message>
    <message>
        <source>%1, more than a row can have; the row stays.</source>
        <translation>%1, mehr als eine Zeile haben kann; die Zeile bleibt.</translation>
    </message>
    <message>
        <source>%1: %2 of this row and at least %3 of the links.</source>
        <translation>%1: %2 aus dieser Zeile und mindestens %3 aus den Gliedern.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source> The row is locked at %1, which is too small.</source>
        <translation> Die Zeile ist bei %1 gesperrt; das ist zu wenig.</translation>
    </message>
    <message>
        <source> The row is locked at %1.</source>
        <translation> Die Zeile ist bei %1 gesperrt.</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>Trennungsabstand</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>stale input</source>
        <translation>veraltete Eingabe</translation>
    </message>
    <message>
        <source>lost person</source>
        <translation>Person verloren</translation>
    </message>
    <message>
        <source>lost connection</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation>Gelenkgeschwindigkeit</translation>
    </message>
    <message>
        <source>bound on speed</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>user</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>braking path</source>
        <translation>Bremsweg</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 J</source>
        <translation>%1 J</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 N·m</source>
        <translation>%1 N·m</translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation>%1 rad/s</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>slowed down</source>
        <translation>verlangsamt</translation>
    </message>
    <message>
        <source>protective stop</source>
        <translation>Sicherheitshalt</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>waiting for reset</source>
        <translation>wartet auf Quittierung</translation>
    </message>
    <message>
        <source>a cause asks for a stop</source>
        <translation>eine Ursache verlangt einen Stopp</translation>
    </message>
    <message>
        <source>the robot is not at standstill yet</source>
        <translation>er steht noch nicht</translation>
    </message>
    <message>
        <source>, limit %1</source>
        <translation>, Grenze %1</translation>
    </message>
    <message>
        <source>, %1 – %2</source>
        <translation>, %1 – %2</translation>
    </message>
    <message>
        <source>, joint %1</source>
        <translation>, Gelenk %1</translation>
    </message>
    <message>
        <source>%1  %2: %3 → %4</source>
        <translation>%1  %2: %3 → %4</translation>
    </message>
    <message>
        <source>%1, after %2</source>
        <translation>%1, nach %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 rad</source>
        <translation>%1 rad</translation>
    </message>
    <message>
        <source>%1 m/s²</source>
        <translation>%1 m/s²</translation>
    </message>
    <message>
        <source>%1 rad/s²</source>
        <translation>%1 rad/s²</translation>
    </message>
    <message>
        <source>%1 N m</source>
        <translation>%1 N m</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>Kraft oder Drehmoment</translation>
    </message>
    <message>
        <source>%1  %2: joint %3 beyond its %4 limit: %5, limit %6</source>
        <translation>%1  %2: Gelenk %3 jenseits seiner Grenze (%4): %5, Grenze %6</translation>
    </message>
    <message>
        <source>Robots: running</source>
        <translation>Roboter: laufen</translation>
    </message>
    <message>
        <source>paused: stale</source>
        <translation>pausiert: veraltet</translation>
    </message>
    <message>
        <source>stopped: stale</source>
        <translation>gestoppt: veraltet</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>Begin with an empty window</source>
        <translation>Mit einem leeren Fenster beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation>&amp;Aufnahme öffnen…</translation>
    </message>
    <message>
        <source>Let the person move as in a recording</source>
        <translation>Die Person bewegt sich wie in einer Aufnahme</translation>
    </message>
    <message>
        <source>Recording op&amp;tions…</source>
        <translation>Aufnahme&amp;optionen…</translation>
    </message>
    <message>
        <source>Say how recordings are understood: units, axis, speed</source>
        <translation>Festlegen, wie Aufnahmen zu verstehen sind: Einheiten, Achse, Geschwindigkeit</translation>
    </message>
    <message>
        <source>Re&amp;load</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>Read the scene and its recordings again; margins and view stay</source>
        <translation>Szene und Aufnahmen neu lesen; Sicherheitsabstände und Ansicht bleiben</translation>
    </message>
    <message>
        <source>Recent file 1</source>
        <translation>Zuletzt geöffnete Datei 1</translation>
    </message>
    <message>
        <source>Open the file that was opened last</source>
        <translation>Die zuletzt geöffnete Datei öffnen</translation>
    </message>
    <message>
        <source>Recent file 2</source>
        <translation>Zuletzt geöffnete Datei 2</translation>
    </message>
    <message>
        <source>Open an earlier file</source>
        <translation>Eine früher geöffnete Datei öffnen</translation>
    </message>
    <message>
        <source>Recent file 3</source>
        <translation>Zuletzt geöffnete Datei 3</translation>
    </message>
    <message>
        <source>Recent file 4</source>
        <translation>Zuletzt geöffnete Datei 4</translation>
    </message>
    <message>
        <source>Recent file 5</source>
        <translation>Zuletzt geöffnete Datei 5</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>Save margins, pairs, visibility, bookmarks and view with the scene and the recording</source>
        <translation>Sicherheitsabstände, Paare, Sichtbarkeit, Lesezeichen und Ansicht mit Szene und Aufnahme speichern</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>Projekt speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save into another project file</source>
        <translation>In eine andere Projektdatei speichern</translation>
    </message>
    <message>
        <source>Re&amp;port…</source>
        <translation>Be&amp;richt…</translation>
    </message>
    <message>
        <source>Make a page of the recording with these margins, to be signed</source>
        <translation>Eine Seite über die Aufnahme mit diesen Sicherheitsabständen erstellen, zum Unterschreiben</translation>
    </message>
    <message>
        <source>Screens&amp;hot…</source>
        <translation>Bil&amp;dschirmfoto…</translation>
    </message>
    <message>
        <source>Save a picture of the window</source>
        <translation>Ein Bild des Fensters speichern</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Put a picture of the 3D view on the clipboard</source>
        <translation>Ein Bild der 3D-Ansicht in die Zwischenablage legen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Das Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Die zurückgenommene Änderung erneut ausführen</translation>
    </message>
    <message>
        <source>&amp;Forces</source>
        <translation>&amp;Kräfte</translation>
    </message>
    <message>
        <source>&amp;Torques</source>
        <translation>&amp;Drehmomente</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Show velocities as thin arrows</source>
        <translation>Geschwindigkeiten als dünne Pfeile zeigen</translation>
    </message>
    <message>
        <source>&amp;Closest points</source>
        <translation>&amp;Nächste Punkte</translation>
    </message>
    <message>
        <source>Show the closest points of the nearest pairs</source>
        <translation>Die nächsten Punkte der nächsten Paare zeigen</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Beschriftungen</translation>
    </message>
    <message>
        <source>F&amp;loor</source>
        <translation>B&amp;oden</translation>
    </message>
    <message>
        <source>Show floor and grid</source>
        <translation>Boden und Raster zeigen</translation>
    </message>
    <message>
        <source>&amp;Shadows</source>
        <translation>Sch&amp;atten</translation>
    </message>
    <message>
        <source>Show shadows on the floor</source>
        <translation>Schatten auf dem Boden zeigen</translation>
    </message>
    <message>
        <source>Transparent &amp;people</source>
        <translation>Durchsichtige &amp;Personen</translation>
    </message>
    <message>
        <source>See through body parts</source>
        <translation>Durch Körperteile hindurchsehen</translation>
    </message>
    <message>
        <source>&amp;Automatic arrow scale</source>
        <translation>Au&amp;tomatische Pfeillänge</translation>
    </message>
    <message>
        <source>Scale arrows to the largest visible force instead of a fixed length per newton</source>
        <translation>Pfeile nach der größten sichtbaren Kraft bemessen statt mit fester Länge je Newton</translation>
    </message>
    <message>
        <source>Plots f&amp;ollow the time</source>
        <translation>Diagramme &amp;folgen der Zeit</translation>
    </message>
    <message>
        <source>Keep the playhead in the plots&apos; window</source>
        <translation>Die Zeitmarke im Fenster der Diagramme halten</translation>
    </message>
    <message>
        <source>Fi&amp;nd pair</source>
        <translation>Paar s&amp;uchen</translation>
    </message>
    <message>
        <source>Go to the filter of the pair table</source>
        <translation>Zum Filter der Tabelle der Paare gehen</translation>
    </message>
    <message>
        <source>Clear &amp;selection</source>
        <translation>Aus&amp;wahl aufheben</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Dunk&amp;les Design</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Hell auf dunkel</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Den ganzen Bildschirm nutzen</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Put all panels where they were at first</source>
        <translation>Alle Bereiche an ihren ersten Platz setzen</translation>
    </message>
    <message>
        <source>&amp;System language</source>
        <translation>Sprache des &amp;Systems</translation>
    </message>
    <message>
        <source>Texts and numbers as the system has them, from the next start on</source>
        <translation>Texte und Zahlen wie im System, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>&amp;English</translation>
    </message>
    <message>
        <source>Texts and numbers in English, from the next start on</source>
        <translation>Texte und Zahlen auf Englisch, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Deutsch</source>
        <translation>&amp;Deutsch</translation>
    </message>
    <message>
        <source>Texts and numbers in German, from the next start on</source>
        <translation>Texte und Zahlen auf Deutsch, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Ansicht von vorn</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Side view</source>
        <translation>Ansicht von der Seite</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>View from above</source>
        <translation>Ansicht von oben</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>View from a corner</source>
        <translation>Ansicht aus einer Ecke</translation>
    </message>
    <message>
        <source>Fit &amp;all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Zoom to all</source>
        <translation>Auf alles zoomen</translation>
    </message>
    <message>
        <source>Fit s&amp;election</source>
        <translation>Aus&amp;wahl zeigen</translation>
    </message>
    <message>
        <source>Zoom to the selection</source>
        <translation>Auf die Auswahl zoomen</translation>
    </message>
    <message>
        <source>Orbit left</source>
        <translation>Nach links drehen</translation>
    </message>
    <message>
        <source>Turn the camera about the scene to the left</source>
        <translation>Die Kamera um die Szene nach links drehen</translation>
    </message>
    <message>
        <source>Orbit right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>Turn the camera about the scene to the right</source>
        <translation>Die Kamera um die Szene nach rechts drehen</translation>
    </message>
    <message>
        <source>Orbit up</source>
        <translation>Nach oben drehen</translation>
    </message>
    <message>
        <source>Raise the camera</source>
        <translation>Die Kamera heben</translation>
    </message>
    <message>
        <source>Orbit down</source>
        <translation>Nach unten drehen</translation>
    </message>
    <message>
        <source>Lower the camera</source>
        <translation>Die Kamera senken</translation>
    </message>
    <message>
        <source>Pan left</source>
        <translation>Nach links verschieben</translation>
    </message>
    <message>
        <source>Move the camera to the left</source>
        <translation>Die Kamera nach links verschieben</translation>
    </message>
    <message>
        <source>Pan right</source>
        <translation>Nach rechts verschieben</translation>
    </message>
    <message>
        <source>Move the camera to the right</source>
        <translation>Die Kamera nach rechts verschieben</translation>
    </message>
    <message>
        <source>Pan up</source>
        <translation>Nach oben verschieben</translation>
    </message>
    <message>
        <source>Move the camera up</source>
        <translation>Die Kamera nach oben verschieben</translation>
    </message>
    <message>
        <source>Pan down</source>
        <translation>Nach unten verschieben</translation>
    </message>
    <message>
        <source>Move the camera down</source>
        <translation>Die Kamera nach unten verschieben</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Move the camera nearer</source>
        <translation>Die Kamera näher heranführen</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Move the camera away</source>
        <translation>Die Kamera weiter wegführen</translation>
    </message>
    <message>
        <source>&amp;As in the scene</source>
        <translation>&amp;Wie in der Szene</translation>
    </message>
    <message>
        <source>All safety margins as in the scene file</source>
        <translation>Alle Sicherheitsabstände wie in der Szenendatei</translation>
    </message>
    <message>
        <source>&amp;None (0 mm)</source>
        <translation>&amp;Keine (0 mm)</translation>
    </message>
    <message>
        <source>All margins 0</source>
        <translation>Alle Sicherheitsabstände 0</translation>
    </message>
    <message>
        <source>All &amp;50 mm</source>
        <translation>Alle &amp;50 mm</translation>
    </message>
    <message>
        <source>All margins 50 mm; that of a pair is the sum of two</source>
        <translation>Alle Sicherheitsabstände 50 mm; der eines Paares ist die Summe von zweien</translation>
    </message>
    <message>
        <source>All &amp;100 mm</source>
        <translation>Alle &amp;100 mm</translation>
    </message>
    <message>
        <source>All margins 100 mm; that of a pair is the sum of two</source>
        <translation>Alle Sicherheitsabstände 100 mm; der eines Paares ist die Summe von zweien</translation>
    </message>
    <message>
        <source>All &amp;200 mm</source>
        <translation>Alle &amp;200 mm</translation>
    </message>
    <message>
        <source>All margins 200 mm; that of a pair is the sum of two</source>
        <translation>Alle Sicherheitsabstände 200 mm; der eines Paares ist die Summe von zweien</translation>
    </message>
    <message>
        <source>&amp;Find margin</source>
        <translation>Sicherheitsabstand &amp;suchen</translation>
    </message>
    <message>
        <source>Go to the search field of the margins</source>
        <translation>Zum Suchfeld der Sicherheitsabstände gehen</translation>
    </message>
    <message>
        <source>&amp;Copy margins</source>
        <translation>Sicherheitsabstände ko&amp;pieren</translation>
    </message>
    <message>
        <source>Put the margins of people and robots on the clipboard, as a set that abstand tune reads</source>
        <translation>Die Sicherheitsabstände von Personen und Robotern in die Zwischenablage legen, als Abstandssatz, den abstand tune liest</translation>
    </message>
    <message>
        <source>&amp;Paste margins</source>
        <translation>Sicherheitsabstände &amp;einfügen</translation>
    </message>
    <message>
        <source>Take the set of margins that is on the clipboard</source>
        <translation>Den Abstandssatz aus der Zwischenablage übernehmen</translation>
    </message>
    <message>
        <source>&amp;Open margins…</source>
        <translation>Sicherheitsabstände ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Take a set of margins from a file of abstand tune --margin-set</source>
        <translation>Einen Abstandssatz aus einer Datei von abstand tune --margin-set übernehmen</translation>
    </message>
    <message>
        <source>&amp;Save margins…</source>
        <translation>Sicherheitsabstände spei&amp;chern…</translation>
    </message>
    <message>
        <source>Save the margins of people and robots as a set for abstand tune --margin-set</source>
        <translation>Die Sicherheitsabstände von Personen und Robotern als Abstandssatz für abstand tune --margin-set speichern</translation>
    </message>
    <message>
        <source>P&amp;ropose margins…</source>
        <translation>Sicherheitsabstände &amp;vorschlagen…</translation>
    </message>
    <message>
        <source>The smallest margins without a missed stop in this recording</source>
        <translation>Die kleinsten Sicherheitsabstände ohne verpassten Stopp in dieser Aufnahme</translation>
    </message>
    <message>
        <source>Co&amp;mpare with these margins</source>
        <translation>Mit diesen Sicherheitsabständen ver&amp;gleichen</translation>
    </message>
    <message>
        <source>Keep the present margins, and show in the timeline what later ones do differently</source>
        <translation>Die jetzigen Sicherheitsabstände merken und in der Zeitleiste zeigen, was spätere anders bewirken</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Wiedergeben</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Wiedergeben oder anhalten</translation>
    </message>
    <message>
        <source>Frame &amp;back</source>
        <translation>Ein &amp;Bild zurück</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Um ein Einzelbild zurück</translation>
    </message>
    <message>
        <source>Frame &amp;forward</source>
        <translation>Ein Bild &amp;vor</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Um ein Einzelbild vor</translation>
    </message>
    <message>
        <source>Second b&amp;ack</source>
        <translation>Eine Sekunde &amp;zurück</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Um eine Sekunde zurück</translation>
    </message>
    <message>
        <source>Second f&amp;orward</source>
        <translation>Eine Sekunde v&amp;or</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>Um eine Sekunde vor</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Zum &amp;Anfang</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>Zum ersten Einzelbild gehen</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Go to the last frame</source>
        <translation>Zum letzten Einzelbild gehen</translation>
    </message>
    <message>
        <source>&amp;Go to time…</source>
        <translation>&amp;Gehe zu Zeit…</translation>
    </message>
    <message>
        <source>Type a time or a frame to go to</source>
        <translation>Eine Zeit oder ein Einzelbild eingeben</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Pre&amp;vious event</source>
        <translation>Vor&amp;heriges Ereignis</translation>
    </message>
    <message>
        <source>Pause at e&amp;vents</source>
        <translation>Bei Ereignissen anhal&amp;ten</translation>
    </message>
    <message>
        <source>Set &amp;IN</source>
        <translation>&amp;IN setzen</translation>
    </message>
    <message>
        <source>The chosen range begins at this moment</source>
        <translation>Der gewählte Bereich beginnt in diesem Augenblick</translation>
    </message>
    <message>
        <source>Set &amp;OUT</source>
        <translation>O&amp;UT setzen</translation>
    </message>
    <message>
        <source>The chosen range ends at this moment</source>
        <translation>Der gewählte Bereich endet in diesem Augenblick</translation>
    </message>
    <message>
        <source>&amp;Clear IN and OUT</source>
        <translation>IN und OUT &amp;löschen</translation>
    </message>
    <message>
        <source>Choose the whole recording</source>
        <translation>Die ganze Aufnahme wählen</translation>
    </message>
    <message>
        <source>Zoom time in</source>
        <translation>Zeit vergrößern</translation>
    </message>
    <message>
        <source>Show less time in the lanes, around this moment (Ctrl and the wheel over them)</source>
        <translation>Weniger Zeit in den Spuren zeigen, um diesen Augenblick (Strg und Mausrad darüber)</translation>
    </message>
    <message>
        <source>Zoom time out</source>
        <translation>Zeit verkleinern</translation>
    </message>
    <message>
        <source>Show more time in the lanes</source>
        <translation>Mehr Zeit in den Spuren zeigen</translation>
    </message>
    <message>
        <source>Show all time</source>
        <translation>Ganze Zeit zeigen</translation>
    </message>
    <message>
        <source>Show the whole recording in the lanes</source>
        <translation>Die ganze Aufnahme in den Spuren zeigen</translation>
    </message>
    <message>
        <source>Add &amp;bookmark…</source>
        <translation>Lesezei&amp;chen setzen…</translation>
    </message>
    <message>
        <source>Remember this moment with its view and a note</source>
        <translation>Diesen Augenblick mit seiner Ansicht und einer Notiz merken</translation>
    </message>
    <message>
        <source>Remove bookmark</source>
        <translation>Lesezeichen entfernen</translation>
    </message>
    <message>
        <source>Remove the bookmark at this frame</source>
        <translation>Das Lesezeichen bei diesem Einzelbild entfernen</translation>
    </message>
    <message>
        <source>Next bookmark</source>
        <translation>Nächstes Lesezeichen</translation>
    </message>
    <message>
        <source>Go to the next bookmark and its view</source>
        <translation>Zum nächsten Lesezeichen und seiner Ansicht gehen</translation>
    </message>
    <message>
        <source>Previous bookmark</source>
        <translation>Vorheriges Lesezeichen</translation>
    </message>
    <message>
        <source>Go to the bookmark before and its view</source>
        <translation>Zum vorherigen Lesezeichen und seiner Ansicht gehen</translation>
    </message>
    <message>
        <source>Fas&amp;ter</source>
        <translation>&amp;Schneller</translation>
    </message>
    <message>
        <source>The next higher speed</source>
        <translation>Die nächsthöhere Geschwindigkeit</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Langsa&amp;mer</translation>
    </message>
    <message>
        <source>The next lower speed</source>
        <translation>Die nächstniedrigere Geschwindigkeit</translation>
    </message>
    <message>
        <source>Loo&amp;p</source>
        <translation>Wie&amp;derholt abspielen</translation>
    </message>
    <message>
        <source>Begin again at the end, or at IN when OUT is reached</source>
        <translation>Am Ende von vorn beginnen, oder bei IN, wenn OUT erreicht ist</translation>
    </message>
    <message>
        <source>&amp;React</source>
        <translation>&amp;Reagieren</translation>
    </message>
    <message>
        <source>Let robots with a reaction react to people; off: they follow their planned motion</source>
        <translation>Roboter mit Reaktion weichen Personen aus; aus: Sie folgen ihrer Bewegung</translation>
    </message>
    <message>
        <source>Reaction &amp;torques</source>
        <translation>Rea&amp;ktionsmomente</translation>
    </message>
    <message>
        <source>Give the torques of the reactions to the robots&apos; motors; off: they only follow and stop</source>
        <translation>Die Drehmomente der Reaktionen den Motoren der Roboter geben; aus: Sie folgen nur und halten an</translation>
    </message>
    <message>
        <source>Reset protective st&amp;ops</source>
        <translation>Sicherheitshalte &amp;quittieren</translation>
    </message>
    <message>
        <source>Let every robot that waits for a reset go on</source>
        <translation>Jeden Roboter weiterfahren lassen, der auf eine Quittierung wartet</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>All keys on one page</source>
        <translation>Alle Tasten auf einer Seite</translation>
    </message>
    <message>
        <source>&amp;About Abstand</source>
        <translation>Ü&amp;ber Abstand</translation>
    </message>
    <message>
        <source>What this program is, and what it is not</source>
        <translation>Was dieses Programm ist und was nicht</translation>
    </message>
    <message>
        <source>Sa&amp;ve plots…</source>
        <translation>Diagra&amp;mme speichern…</translation>
    </message>
    <message>
        <source>Save the plots as a table or a picture</source>
        <translation>Die Diagramme als Tabelle oder Bild speichern</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Befehl &amp;suchen…</translation>
    </message>
    <message>
        <source>Find a command by its words, and run it</source>
        <translation>Einen Befehl an seinen Wörtern finden und ausführen</translation>
    </message>
    <message>
        <source>Vi&amp;deo…</source>
        <translation>&amp;Video…</translation>
    </message>
    <message>
        <source>Save a video of the 3D view between IN and OUT</source>
        <translation>Ein Video der 3D-Ansicht zwischen IN und OUT speichern</translation>
    </message>
    <message>
        <source>Change &amp;keys…</source>
        <translation>Tasten ä&amp;ndern…</translation>
    </message>
    <message>
        <source>Give commands other keys</source>
        <translation>Befehlen andere Tasten geben</translation>
    </message>
    <message>
        <source>no limits</source>
        <translation>ohne Grenzen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>contact %1, reaction %2</source>
        <translation>Kontakt %1, Reaktion %2</translation>
    </message>
    <message>
        <source>, gravity %1, motion %2</source>
        <translation>, Schwerkraft %1, Bewegung %2</translation>
    </message>
    <message>
        <source>%1 of at most %2 %3</source>
        <translation>%1 von höchstens %2 %3</translation>
    </message>
    <message>
        <source>posed by hand</source>
        <translation>von Hand gestellt</translation>
    </message>
    <message>
        <source>rests</source>
        <translation>ruht</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>folgt %1</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Torque of %1</source>
        <translation>Drehmoment von %1</translation>
    </message>
    <message>
        <source>adjacent</source>
        <translation>benachbart</translation>
    </message>
    <message>
        <source>within the person</source>
        <translation>innerhalb der Person</translation>
    </message>
    <message>
        <source>within the robot or the room</source>
        <translation>innerhalb des Roboters oder Raums</translation>
    </message>
    <message>
        <source>dropped by a file</source>
        <translation>durch eine Datei ausgenommen</translation>
    </message>
    <message>
        <source>excluded by the scene</source>
        <translation>von der Szene ausgeschlossen</translation>
    </message>
    <message>
        <source>none: all its pairs are checked</source>
        <translation>keine: alle seine Paare werden geprüft</translation>
    </message>
    <message>
        <source>known within %1</source>
        <translation>bekannt auf %1</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>inferred, within %1</source>
        <translation>erschlossen, auf %1</translation>
    </message>
    <message>
        <source>? lost: where it was last seen</source>
        <translation>? verloren: wo er zuletzt gesehen wurde</translation>
    </message>
    <message>
        <source>? refused: the last good one is shown</source>
        <translation>? abgelehnt: gezeigt ist die letzte gültige</translation>
    </message>
    <message>
        <source>Nearest person</source>
        <translation>Nächste Person</translation>
    </message>
    <message>
        <source>Nearest robot or thing</source>
        <translation>Nächster Roboter oder Gegenstand</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nichts ist ausgewählt</translation>
    </message>
    <message>
        <source>%1 bodies</source>
        <translation>%1 Körper</translation>
    </message>
    <message>
        <source>⚠ touching</source>
        <translation>⚠ berührt</translation>
    </message>
    <message>
        <source>? pose lost</source>
        <translation>? Pose verloren</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? nicht geprüft</translation>
    </message>
    <message>
        <source>▲ near</source>
        <translation>▲ nahe</translation>
    </message>
    <message>
        <source>⚠ inside margin</source>
        <translation>⚠ unterschritten</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1: %2 – %3 at %4</source>
        <translation>%1: %2 – %3 bei %4</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position, %1</source>
        <translation>Position, %1</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1, y %2, z %3 m</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>body part of the person %1</source>
        <translation>Körperteil der Person %1</translation>
    </message>
    <message>
        <source>thing in the room</source>
        <translation>Gegenstand im Raum</translation>
    </message>
    <message>
        <source>link of the robot %1</source>
        <translation>Glied des Roboters %1</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 m/s, turns at %2/s</source>
        <translation>%1 m/s, dreht mit %2/s</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m</source>
        <translation>%1 × %2 × %3 m</translation>
    </message>
    <message>
        <source>Shell points</source>
        <translation>Hüllpunkte</translation>
    </message>
    <message>
        <source>%1, %2 apart</source>
        <translation>%1, je %2 entfernt</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Error bound</source>
        <translation>Fehlerschranke</translation>
    </message>
    <message>
        <source>Fastest body</source>
        <translation>Schnellster Körper</translation>
    </message>
    <message>
        <source>%1 m/s, %2</source>
        <translation>%1 m/s, %2</translation>
    </message>
    <message>
        <source>robot with %1 joints</source>
        <translation>Roboter mit %1 Gelenken</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>person of %1 body parts</source>
        <translation>Person aus %1 Körperteilen</translation>
    </message>
    <message>
        <source>Stature</source>
        <translation>Körpergröße</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>female</source>
        <translation>weiblich</translation>
    </message>
    <message>
        <source>male</source>
        <translation>männlich</translation>
    </message>
    <message>
        <source>not given: mean of both</source>
        <translation>nicht angegeben: Mittel beider</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>percentile %1</source>
        <translation>Perzentil %1</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>none: stands still</source>
        <translation>keine: steht still</translation>
    </message>
    <message>
        <source>Oldest part seen</source>
        <translation>Am längsten nicht gesehen</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>vor %1</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>When last checked</source>
        <translation>Bei der letzten Prüfung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1 and %2 for the poses</source>
        <translation>%1 und %2 für die Posen</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 von %2 Paaren</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw</source>
        <translation>Rollen, Nicken, Gieren</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw, %1</source>
        <translation>Rollen, Nicken, Gieren, %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1, uncertainty %2</source>
        <translation>%1, Unsicherheit %2</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>Wegen</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 Paare</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Theme of the s&amp;ystem</source>
        <translation>Farben des S&amp;ystems</translation>
    </message>
    <message>
        <source>Light or dark as the system was when the program started</source>
        <translation>Hell oder dunkel wie das System beim Start des Programms</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>&amp;Scale to the largest in sight</source>
        <translation>&amp;Nach dem größten sichtbaren skalieren</translation>
    </message>
    <message>
        <source>Length per &amp;newton</source>
        <translation>Länge je Ne&amp;wton</translation>
    </message>
    <message>
        <source>Length per ne&amp;wton metre</source>
        <translation>Länge je Newton&amp;meter</translation>
    </message>
    <message>
        <source>Length per &amp;metre per second</source>
        <translation>Länge je Meter pro &amp;Sekunde</translation>
    </message>
    <message>
        <source>Least &amp;force</source>
        <translation>Kleinste &amp;Kraft</translation>
    </message>
    <message>
        <source>Least &amp;torque</source>
        <translation>Kleinstes &amp;Drehmoment</translation>
    </message>
    <message>
        <source>Least s&amp;peed</source>
        <translation>Kleinste &amp;Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>; to be checked: %1</source>
        <translation>; zu prüfen: %1</translation>
    </message>
    <message>
        <source>Contact at this speed, region &quot;%1&quot;: %2</source>
        <translation>Kontakt bei dieser Geschwindigkeit, Region „%1“: %2</translation>
    </message>
    <message>
        <source>Contact with this region is excluded at any speed [%1]</source>
        <translation>Kontakt mit dieser Region ist bei jeder Geschwindigkeit ausgeschlossen [%1]</translation>
    </message>
    <message>
        <source>limit of the force %1 N</source>
        <translation>Grenzwert der Kraft %1 N</translation>
    </message>
    <message>
        <source>times %1 for a part that can recoil</source>
        <translation>mal %1 für ein Körperteil, das ausweichen kann</translation>
    </message>
    <message>
        <source>stiffness %1 N/mm</source>
        <translation>Steifigkeit %1 N/mm</translation>
    </message>
    <message>
        <source>mass of the region %1 kg</source>
        <translation>Masse der Region %1 kg</translation>
    </message>
    <message>
        <source>mass of the robot %1 kg [set here]</source>
        <translation>Masse des Roboters %1 kg [hier eingestellt]</translation>
    </message>
    <message>
        <source>mass of the robot not known: counts as immovable [on the safe side]</source>
        <translation>Masse des Roboters nicht bekannt: gilt als unbeweglich [auf der sicheren Seite]</translation>
    </message>
    <message>
        <source>permitted speed towards each other %1 m/s</source>
        <translation>zulässige Geschwindigkeit aufeinander zu %1 m/s</translation>
    </message>
    <message>
        <source>%1 to spare</source>
        <translation>%1 Reserve</translation>
    </message>
    <message>
        <source>%1 short, no approach</source>
        <translation>%1 zu wenig, ruht</translation>
    </message>
    <message>
        <source>⚠ %1 short</source>
        <translation>⚠ %1 zu wenig</translation>
    </message>
    <message>
        <source>no pair is checked</source>
        <translation>kein Paar geprüft</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>moving apart</source>
        <translation>entfernen sich</translation>
    </message>
    <message>
        <source>⚠ excluded</source>
        <translation>⚠ ausgeschlossen</translation>
    </message>
    <message>
        <source>⚠ %1 of %2 N</source>
        <translation>⚠ %1 von %2 N</translation>
    </message>
    <message>
        <source>%1 of %2 N</source>
        <translation>%1 von %2 N</translation>
    </message>
    <message>
        <source>%1: no pair with a robot is checked</source>
        <translation>%1: kein Paar mit einem Roboter wird geprüft</translation>
    </message>
    <message>
        <source>%1 – %2: %3</source>
        <translation>%1 – %2: %3</translation>
    </message>
    <message>
        <source>certified clearance %1 [distance − uncertainty − poses]</source>
        <translation>gesicherter Abstand %1 [Abstand − Unsicherheit − Posen]</translation>
    </message>
    <message>
        <source>S_h, the person: %1 [ISO 13855:2010: %2 m/s, or %3 m/s nearer than %4]</source>
        <translation>S_h, die Person: %1 [ISO 13855:2010: %2 m/s, näher als %4 sind es %3 m/s]</translation>
    </message>
    <message>
        <source>S_r, reaction: %1 [robot at %2 m/s for %3 s, set here]</source>
        <translation>S_r, Reaktion: %1 [Roboter mit %2 m/s für %3 s, hier eingestellt]</translation>
    </message>
    <message>
        <source>S_s, stopping: %1 [at %2 m/s², set here]</source>
        <translation>S_s, Anhalten: %1 [mit %2 m/s², hier eingestellt]</translation>
    </message>
    <message>
        <source>S_s, stopping: %1 [in %2 s, set here]</source>
        <translation>S_s, Anhalten: %1 [in %2 s, hier eingestellt]</translation>
    </message>
    <message>
        <source>C + Z_d + Z_r: %1 [set here]</source>
        <translation>C + Z_d + Z_r: %1 [hier eingestellt]</translation>
    </message>
    <message>
        <source>S_p, their sum: %1 [ISO/TS 15066:2016, 5.5.4]</source>
        <translation>S_p, ihre Summe: %1 [ISO/TS 15066:2016, 5.5.4]</translation>
    </message>
    <message>
        <source>towards each other: robot %1 m/s, person %2 m/s</source>
        <translation>aufeinander zu: Roboter %1 m/s, Person %2 m/s</translation>
    </message>
    <message>
        <source>the robot may approach at %1 m/s</source>
        <translation>der Roboter darf sich mit %1 m/s nähern</translation>
    </message>
    <message>
        <source>Save ran&amp;ge as recording…</source>
        <translation>Bereich als Aufna&amp;hme speichern…</translation>
    </message>
    <message>
        <source>Save the joints between IN and OUT as a recording of its own</source>
        <translation>Die Gelenke zwischen IN und OUT als eigene Aufnahme speichern</translation>
    </message>
    <message>
        <source>Open pairs (SRDF)…</source>
        <translation>Paare öffnen (SRDF)…</translation>
    </message>
    <message>
        <source>Do not check the pairs of a robot&apos;s links that a file disables</source>
        <translation>Die Paare von Gliedern eines Roboters nicht prüfen, die eine Datei abschaltet</translation>
    </message>
    <message>
        <source>Save pairs (SRD&amp;F)…</source>
        <translation>Paare spei&amp;chern (SRDF)…</translation>
    </message>
    <message>
        <source>Save which pairs of a robot&apos;s links are not checked, for MoveIt</source>
        <translation>Für MoveIt speichern, welche Paare von Gliedern eines Roboters nicht geprüft werden</translation>
    </message>
    <message>
        <source>Arrows…</source>
        <translation>Pfeile…</translation>
    </message>
    <message>
        <source>Length of arrows, and the least force, torque and speed that are drawn</source>
        <translation>Länge der Pfeile und die kleinste Kraft, das kleinste Drehmoment und die kleinste Geschwindigkeit, die gezeichnet werden</translation>
    </message>
    <message>
        <source>Keep the selection in the plot</source>
        <translation>Auswahl im Diagramm behalten</translation>
    </message>
    <message>
        <source>The distance plot shows the selected bodies or pair from now on</source>
        <translation>Das Abstandsdiagramm zeigt von nun an die ausgewählten Körper oder das Paar</translation>
    </message>
    <message>
        <source>Plot the selection only</source>
        <translation>Nur die Auswahl im Diagramm</translation>
    </message>
    <message>
        <source>Take from the distance plot what was kept there</source>
        <translation>Aus dem Abstandsdiagramm nehmen, was dort behalten wurde</translation>
    </message>
    <message>
        <source>Lengths in metres</source>
        <translation>Längen in Metern</translation>
    </message>
    <message>
        <source>Show lengths in metres instead of millimetres; files keep their units</source>
        <translation>Längen in Metern statt Millimetern zeigen; Dateien behalten ihre Einheiten</translation>
    </message>
    <message>
        <source>Angles in radians</source>
        <translation>Winkel in Bogenmaß</translation>
    </message>
    <message>
        <source>Show angles in radians instead of degrees; files keep their units</source>
        <translation>Winkel in Radiant statt Grad zeigen; Dateien behalten ihre Einheiten</translation>
    </message>
    <message>
        <source>Fo&amp;llow the selection</source>
        <translation>Auswah&amp;l verfolgen</translation>
    </message>
    <message>
        <source>Let the camera move with the selected bodies</source>
        <translation>Die Kamera bewegt sich mit den ausgewählten Körpern</translation>
    </message>
    <message>
        <source>View &amp;before</source>
        <translation>Ansicht &amp;davor</translation>
    </message>
    <message>
        <source>Put the camera where it was before it moved</source>
        <translation>Die Kamera dorthin stellen, wo sie vor ihrer Bewegung war</translation>
    </message>
    <message>
        <source>View after</source>
        <translation>Ansicht danach</translation>
    </message>
    <message>
        <source>Take back the step to the view before</source>
        <translation>Den Schritt zur Ansicht davor zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>What is where, in a minute</source>
        <translation>Was wo ist, in einer Minute</translation>
    </message>
    <message>
        <source>The 3D view</source>
        <translation>Die 3D-Ansicht</translation>
    </message>
    <message>
        <source>Drag with the left button to orbit, with the right one to pan, and turn the wheel to zoom. A click selects a body. Thin lines join the nearest points of people and robots; what is inside its margin is vermillion with an outline.</source>
        <translation>Mit der linken Taste ziehen dreht, mit der rechten verschiebt, das Rad zoomt. Ein Klick wählt einen Körper aus. Dünne Linien verbinden die nächsten Punkte von Personen und Robotern; was seinen Sicherheitsabstand unterschreitet, ist zinnoberrot mit Umriss.</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>All bodies by group, each with its distance to the nearest person or robot. A tick hides and shows; a body can be dragged onto the plots.</source>
        <translation>Alle Körper nach Gruppen, jeder mit seinem Abstand zur nächsten Person oder zum nächsten Roboter. Ein Häkchen blendet aus und ein; ein Körper lässt sich auf die Diagramme ziehen.</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>Die Zeitleiste</translation>
    </message>
    <message>
        <source>Space plays, the arrow keys step, and a drag in the strip scrubs. Each body part has a lane: bright is near, a vermillion bar is inside the margin, hatched is not known. N goes to the next event.</source>
        <translation>Die Leertaste spielt ab, die Pfeiltasten gehen Bild für Bild, Ziehen im Streifen fährt durch die Zeit. Jedes Körperteil hat eine Spur: hell ist nah, ein zinnoberroter Balken heißt unterschritten, schraffiert heißt nicht bekannt. N geht zum nächsten Ereignis.</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Sicherheitsabstände</translation>
    </message>
    <message>
        <source>The safety margin of each body. Drag a slider: lanes, events and the sentence above the strip say at once what it would have done over the whole recording.</source>
        <translation>Der Sicherheitsabstand jedes Körpers. Beim Ziehen eines Reglers sagen Spuren, Ereignisse und der Satz über dem Streifen sofort, was er über die ganze Aufnahme bewirkt hätte.</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Each pair of bodies with its distance and its uncertainty. The true distance is never below distance minus uncertainty.</source>
        <translation>Jedes Paar von Körpern mit Abstand und Unsicherheit. Der wahre Abstand ist nie kleiner als Abstand minus Unsicherheit.</translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Schutzabstand</translation>
    </message>
    <message>
        <source>For each body part the protective distance that ISO/TS 15066:2016 asks for at this moment, term by term, against the distance that is there; and how a contact would compare with its limit.</source>
        <translation>Für jedes Körperteil der Schutzabstand, den ISO/TS 15066:2016 in diesem Moment verlangt, Summand für Summand, neben dem vorhandenen Abstand; und wie ein Kontakt zu seinem Grenzwert stünde.</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>All that is known of the selection. A robot has sliders for its joints, a person fields for stature and mass.</source>
        <translation>Alles, was von der Auswahl bekannt ist. Ein Roboter hat Regler für seine Gelenke, eine Person Felder für Körpergröße und Masse.</translation>
    </message>
    <message>
        <source>Reservations</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>What weakens the results: lost poses, gaps, guessed units. Read it before you believe a number. This is an analysis tool, not a safety function.</source>
        <translation>Was die Ergebnisse schwächt: verlorene Posen, Lücken, geratene Einheiten. Vor dem Vertrauen in eine Zahl zu lesen. Dies ist ein Werkzeug zur Analyse, keine Sicherheitsfunktion.</translation>
    </message>
    <message>
        <source>Import recording…</source>
        <translation>Aufnahme importieren…</translation>
    </message>
    <message>
        <source>Open a recording of unknown joints: say which is which, and see the skeleton that comes of it</source>
        <translation>Eine Aufnahme mit unbekannten Gelenken öffnen: sagen, welches welches ist, und das Skelett sehen, das daraus wird</translation>
    </message>
    <message>
        <source>Look &amp;inside the selection</source>
        <translation>&amp;In die Auswahl hineinsehen</translation>
    </message>
    <message>
        <source>Shell points, tree spheres, a slice of the distance field, or nothing of the selected bodies</source>
        <translation>Hüllpunkte, Kugeln des Baums, ein Schnitt durch das Abstandsfeld oder nichts der ausgewählten Körper</translation>
    </message>
    <message>
        <source>Next tree level</source>
        <translation>Nächste Baumebene</translation>
    </message>
    <message>
        <source>Show smaller spheres of the tree</source>
        <translation>Kleinere Kugeln des Baums zeigen</translation>
    </message>
    <message>
        <source>Tree level before</source>
        <translation>Baumebene davor</translation>
    </message>
    <message>
        <source>Show larger spheres of the tree</source>
        <translation>Größere Kugeln des Baums zeigen</translation>
    </message>
    <message>
        <source>Layout for repla&amp;y</source>
        <translation>Anordnung zum Ab&amp;spielen</translation>
    </message>
    <message>
        <source>Scene, timeline and inspector only</source>
        <translation>Nur Szene, Zeitleiste und Inspektor</translation>
    </message>
    <message>
        <source>Layout for tuning</source>
        <translation>Anordnung zum Abstimmen</translation>
    </message>
    <message>
        <source>Margins, margin curve, events and plots around the timeline</source>
        <translation>Abstände, Abstandskurve, Ereignisse und Diagramme um die Zeitleiste</translation>
    </message>
    <message>
        <source>Layout for review</source>
        <translation>Anordnung zum Prüfen</translation>
    </message>
    <message>
        <source>Events, reservations and what was read of the recordings</source>
        <translation>Ereignisse, Zweifel und was von den Aufnahmen gelesen wurde</translation>
    </message>
    <message>
        <source>Joint torques</source>
        <translation>Gelenkmomente</translation>
    </message>
    <message>
        <source>%1, frame %2: %3</source>
        <translation>%1, Bild %2: %3</translation>
    </message>
    <message>
        <source>%1 not seen</source>
        <translation>%1 nicht gesehen</translation>
    </message>
    <message>
        <source>%1 – %2: %3 ± %4, so at least %5; %6%7</source>
        <translation>%1 – %2: %3 ± %4, also mindestens %5; %6%7</translation>
    </message>
    <message>
        <source>%1: not known</source>
        <translation>%1: nicht bekannt</translation>
    </message>
    <message>
        <source>tracked</source>
        <translation>verfolgt</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>erschlossen</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>uncertainty not known</source>
        <translation>Unsicherheit nicht bekannt</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Body over the depth image</source>
        <translation>Körper über dem Tiefenbild</translation>
    </message>
    <message>
        <source>Draw the fitted body and its joints over the depth image</source>
        <translation>Den angepassten Körper und seine Gelenke über das Tiefenbild zeichnen</translation>
    </message>
    <message>
        <source>Earlier time in the lanes</source>
        <translation>Frühere Zeit in den Spuren</translation>
    </message>
    <message>
        <source>Move what the zoomed lanes show to an earlier time</source>
        <translation>Den Ausschnitt der Spuren zu einer früheren Zeit verschieben</translation>
    </message>
    <message>
        <source>Later time in the lanes</source>
        <translation>Spätere Zeit in den Spuren</translation>
    </message>
    <message>
        <source>Move what the zoomed lanes show to a later time</source>
        <translation>Den Ausschnitt der Spuren zu einer späteren Zeit verschieben</translation>
    </message>
    <message>
        <source>Move link left</source>
        <translation>Glied nach links</translation>
    </message>
    <message>
        <source>Move link right</source>
        <translation>Glied nach rechts</translation>
    </message>
    <message>
        <source>Move link up</source>
        <translation>Glied nach oben</translation>
    </message>
    <message>
        <source>Move link down</source>
        <translation>Glied nach unten</translation>
    </message>
    <message>
        <source>Move link nearer</source>
        <translation>Glied näher</translation>
    </message>
    <message>
        <source>Move link farther</source>
        <translation>Glied weiter weg</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>recorded moments</source>
        <translation>aufgezeichnete Momente</translation>
    </message>
    <message>
        <source>⚠ stale: the server shows another scene</source>
        <translation>⚠ veraltet: Der Server zeigt eine andere Szene</translation>
    </message>
    <message>
        <source>⚠ stale: nothing received for %1</source>
        <translation>⚠ veraltet: nichts empfangen seit %1</translation>
    </message>
    <message>
        <source>⚠ not connected</source>
        <translation>⚠ nicht verbunden</translation>
    </message>
    <message>
        <source>connected, %1 moments/s, newest %2 old</source>
        <translation>verbunden, %1 Momente/s, neuester %2 alt</translation>
    </message>
    <message>
        <source>%1 ago; %2</source>
        <translation>vor %1; %2</translation>
    </message>
    <message>
        <source>⚠ scene file differs; %1</source>
        <translation>⚠ Szenendatei weicht ab; %1</translation>
    </message>
    <message>
        <source>Shown is what abstand serve computed. Margins, pairs and poses are the server&apos;s.</source>
        <translation>Gezeigt wird, was abstand serve berechnet hat. Sicherheitsabstände, Paare und Posen sind die des Servers.</translation>
    </message>
    <message>
        <source>Kept: the last %1, %2 MiB</source>
        <translation>Aufbewahrt: die letzten %1, %2 MiB</translation>
    </message>
    <message>
        <source>Moments that the server left out because this window was too slow: %1</source>
        <translation>Momente, die der Server ausgelassen hat, weil dieses Fenster zu langsam war: %1</translation>
    </message>
    <message>
        <source>The scene file here has another content than the server&apos;s: shapes, margins and limits may differ.</source>
        <translation>Die Szenendatei hier hat einen anderen Inhalt als die des Servers: Formen, Sicherheitsabstände und Grenzen können abweichen.</translation>
    </message>
    <message>
        <source>Connect to a running serve…</source>
        <translation>Mit laufendem serve verbinden…</translation>
    </message>
    <message>
        <source>Show what abstand serve computes now, keep the last ten minutes, and go back in them</source>
        <translation>Zeigen, was abstand serve jetzt berechnet, die letzten zehn Minuten aufbewahren und darin zurückgehen</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Verbindung trennen</translation>
    </message>
    <message>
        <source>Show the scene by itself again, without the server</source>
        <translation>Die Szene wieder allein zeigen, ohne den Server</translation>
    </message>
    <message>
        <source>Save the recording…</source>
        <translation>Die Aufzeichnung speichern…</translation>
    </message>
    <message>
        <source>Save the last ten minutes of the server as a file that this program opens again</source>
        <translation>Die letzten zehn Minuten des Servers als Datei speichern, die dieses Programm wieder öffnet</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zur Gegenwart</translation>
    </message>
    <message>
        <source>Show what the server computes now, after a look at what was</source>
        <translation>Zeigen, was der Server jetzt berechnet, nach einem Blick zurück</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Joint efforts of contacts and pokes, times a gain, reach the motors.</source>
        <translation>Gelenkmomente von Kontakten und Stößen wirken, mal einer Verstärkung, auf die Motoren.</translation>
    </message>
    <message>
        <source>Repulsion</source>
        <translation>Abstoßung</translation>
    </message>
    <message>
        <source>A potential around the links pushes the robot away from bodies.</source>
        <translation>Ein Potential um die Glieder drückt den Roboter von Körpern weg.</translation>
    </message>
    <message>
        <source>Held object</source>
        <translation>Gehaltener Gegenstand</translation>
    </message>
    <message>
        <source>A held object stays on the surface while the hand is pressed in.</source>
        <translation>Ein gehaltener Gegenstand bleibt auf der Oberfläche, während die Hand hineingedrückt wird.</translation>
    </message>
    <message>
        <source>Admittance</source>
        <translation>Admittanz</translation>
    </message>
    <message>
        <source>Turns torques into motion, for a robot that is controlled by positions.</source>
        <translation>Wandelt Momente in Bewegung um, für einen positionsgeregelten Roboter.</translation>
    </message>
    <message>
        <source>Speed and separation</source>
        <translation>Geschwindigkeit und Abstand</translation>
    </message>
    <message>
        <source>Slows the planned motion so that a person keeps the protective distance of ISO/TS 15066.</source>
        <translation>Verlangsamt die geplante Bewegung, damit der Schutzabstand nach ISO/TS 15066 zu Personen bleibt.</translation>
    </message>
    <message>
        <source>Braking</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Stops the robot if a person could reach its braking path.</source>
        <translation>Hält den Roboter an, wenn eine Person seinen Bremsweg erreichen könnte.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Keeps the robot on its planned motion; always active.</source>
        <translation>Hält den Roboter auf seiner geplanten Bewegung; immer aktiv.</translation>
    </message>
    <message>
        <source>Stop conditions</source>
        <translation>Haltebedingungen</translation>
    </message>
    <message>
        <source>What stops the robot, and how it goes on; always active.</source>
        <translation>Was den Roboter anhält und wie es weitergeht; immer aktiv.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Factor on the joint efforts of contacts.</source>
        <translation>Faktor auf die Gelenkmomente von Kontakten.</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Größtes Moment</translation>
    </message>
    <message>
        <source>Limit of the sum of all torques on a joint.</source>
        <translation>Grenze der Summe aller Momente an einem Gelenk.</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>The force begins at this distance.</source>
        <translation>Die Kraft beginnt bei diesem Abstand.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force at distance 0 and inside.</source>
        <translation>Kraft beim Abstand 0 und innen.</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping ratio of the approach; 1: critical.</source>
        <translation>Dämpfungsgrad der Annäherung; 1: aperiodischer Grenzfall.</translation>
    </message>
    <message>
        <source>Effective mass where no mass matrix is known.</source>
        <translation>Effektive Masse, wo keine Massenmatrix bekannt ist.</translation>
    </message>
    <message>
        <source>Stop distance</source>
        <translation>Halteabstand</translation>
    </message>
    <message>
        <source>An approach must have ended at this distance; it must be below the range.</source>
        <translation>Bei diesem Abstand muss eine Annäherung beendet sein; er muss unter der Reichweite liegen.</translation>
    </message>
    <message>
        <source>Stop share</source>
        <translation>Halteanteil</translation>
    </message>
    <message>
        <source>Share of the potential energy that a moving link may use up; above it the brakes engage.</source>
        <translation>Anteil der potentiellen Energie, den ein bewegtes Glied aufbrauchen darf; darüber fallen die Bremsen ein.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Spring between object and hand.</source>
        <translation>Feder zwischen Gegenstand und Hand.</translation>
    </message>
    <message>
        <source>Rotation stiffness</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>Torsion spring between object and hand.</source>
        <translation>Drehfeder zwischen Gegenstand und Hand.</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Limit of the force of the spring.</source>
        <translation>Grenze der Kraft der Feder.</translation>
    </message>
    <message>
        <source>Limit of the torque of the spring.</source>
        <translation>Grenze des Moments der Feder.</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>Distance kept between object and surface.</source>
        <translation>Abstand, der zwischen Gegenstand und Oberfläche bleibt.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Largest displacement of the object in one cycle.</source>
        <translation>Größte Verschiebung des Gegenstands in einem Zyklus.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Virtual inertia of a joint.</source>
        <translation>Virtuelle Trägheit eines Gelenks.</translation>
    </message>
    <message>
        <source>Virtual damper of a joint.</source>
        <translation>Virtueller Dämpfer eines Gelenks.</translation>
    </message>
    <message>
        <source>Virtual spring of a joint; 0: it stays where it was pushed.</source>
        <translation>Virtuelle Feder eines Gelenks; 0: es bleibt, wohin es gedrückt wurde.</translation>
    </message>
    <message>
        <source>Largest velocity</source>
        <translation>Größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>Limit of the velocity that is added.</source>
        <translation>Grenze der hinzugefügten Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Largest offset</source>
        <translation>Größter Versatz</translation>
    </message>
    <message>
        <source>Limit of the way from the planned position.</source>
        <translation>Grenze des Wegs von der geplanten Stellung.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Reaktionszeit</translation>
    </message>
    <message>
        <source>Of sensor, network and controller together.</source>
        <translation>Von Sensor, Netz und Steuerung zusammen.</translation>
    </message>
    <message>
        <source>Stopping time</source>
        <translation>Anhaltezeit</translation>
    </message>
    <message>
        <source>Time that the robot needs to stand.</source>
        <translation>Zeit, die der Roboter bis zum Stillstand braucht.</translation>
    </message>
    <message>
        <source>Deceleration</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>If it is not 0, the stopping time is the speed divided by it.</source>
        <translation>Wenn sie nicht 0 ist, ist die Anhaltezeit die Geschwindigkeit geteilt durch sie.</translation>
    </message>
    <message>
        <source>Intrusion</source>
        <translation>Eindringen</translation>
    </message>
    <message>
        <source>How far a person intrudes before the sensor sees it.</source>
        <translation>Wie weit eine Person eindringt, bevor der Sensor es sieht.</translation>
    </message>
    <message>
        <source>Error of the person</source>
        <translation>Fehler der Person</translation>
    </message>
    <message>
        <source>Error of the measured position of a person.</source>
        <translation>Fehler der gemessenen Lage einer Person.</translation>
    </message>
    <message>
        <source>Error of the robot</source>
        <translation>Fehler des Roboters</translation>
    </message>
    <message>
        <source>Error of the position of the robot.</source>
        <translation>Fehler der Lage des Roboters.</translation>
    </message>
    <message>
        <source>Person&apos;s speed</source>
        <translation>Tempo der Person</translation>
    </message>
    <message>
        <source>Assumed speed of a walking person.</source>
        <translation>Angenommene Geschwindigkeit einer gehenden Person.</translation>
    </message>
    <message>
        <source>Speed when near</source>
        <translation>Tempo in der Nähe</translation>
    </message>
    <message>
        <source>Assumed speed of a person who is near.</source>
        <translation>Angenommene Geschwindigkeit einer nahen Person.</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Within this distance a person is near.</source>
        <translation>Innerhalb dieses Abstands ist eine Person nah.</translation>
    </message>
    <message>
        <source>Person&apos;s acceleration</source>
        <translation>Beschleunigung der Person</translation>
    </message>
    <message>
        <source>Largest acceleration of a person; 0: measured speeds are not used.</source>
        <translation>Größte Beschleunigung einer Person; 0: gemessene Geschwindigkeiten werden nicht verwendet.</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>How fast the share of the speed rises again.</source>
        <translation>Wie schnell der Anteil der Geschwindigkeit wieder steigt.</translation>
    </message>
    <message>
        <source>Smallest share</source>
        <translation>Kleinster Anteil</translation>
    </message>
    <message>
        <source>Smaller shares of the planned speed count as 0.</source>
        <translation>Kleinere Anteile der geplanten Geschwindigkeit zählen als 0.</translation>
    </message>
    <message>
        <source>Of a joint while it brakes.</source>
        <translation>Eines Gelenks, während es bremst.</translation>
    </message>
    <message>
        <source>Until the joints begin to brake.</source>
        <translation>Bis die Gelenke zu bremsen beginnen.</translation>
    </message>
    <message>
        <source>Required distance until the robot stands.</source>
        <translation>Geforderter Abstand, bis der Roboter steht.</translation>
    </message>
    <message>
        <source>A person moves at most this fast meanwhile.</source>
        <translation>So schnell bewegt sich eine Person währenddessen höchstens.</translation>
    </message>
    <message>
        <source>A person accelerates at most this much meanwhile.</source>
        <translation>So stark beschleunigt eine Person währenddessen höchstens.</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>How fast and how stiffly the robot returns to its plan.</source>
        <translation>Wie schnell und wie steif der Roboter zu seinem Plan zurückkehrt.</translation>
    </message>
    <message>
        <source>Damping ratio of the return; 1: no overshoot.</source>
        <translation>Dämpfungsgrad der Rückkehr; 1: kein Überschwingen.</translation>
    </message>
    <message>
        <source>A smaller certified distance stops the robot.</source>
        <translation>Ein kleinerer gesicherter Abstand hält den Roboter an.</translation>
    </message>
    <message>
        <source>Age of joint values</source>
        <translation>Alter der Gelenkwerte</translation>
    </message>
    <message>
        <source>Older joint values stop the robot.</source>
        <translation>Ältere Gelenkwerte halten den Roboter an.</translation>
    </message>
    <message>
        <source>Age of a person</source>
        <translation>Alter einer Person</translation>
    </message>
    <message>
        <source>An older pose of a person stops the robot.</source>
        <translation>Eine ältere Haltung einer Person hält den Roboter an.</translation>
    </message>
    <message>
        <source>Joint speed</source>
        <translation>Gelenktempo</translation>
    </message>
    <message>
        <source>A faster joint stops the robot.</source>
        <translation>Ein schnelleres Gelenk hält den Roboter an.</translation>
    </message>
    <message>
        <source>Resume after</source>
        <translation>Weiter nach</translation>
    </message>
    <message>
        <source>A protective stop ends by itself after this time without a cause; ∞: it waits for a reset.</source>
        <translation>Ein Sicherheitshalt endet nach dieser Zeit ohne Ursache von selbst; ∞: er wartet auf das Quittieren.</translation>
    </message>
    <message>
        <source>Standstill</source>
        <translation>Stillstand</translation>
    </message>
    <message>
        <source>A robot stands if no joint is faster.</source>
        <translation>Ein Roboter steht, wenn kein Gelenk schneller ist.</translation>
    </message>
    <message>
        <source>Settle</source>
        <translation>Beruhigung</translation>
    </message>
    <message>
        <source>Time of standstill before a reset is accepted.</source>
        <translation>Zeit des Stillstands, bevor ein Quittieren angenommen wird.</translation>
    </message>
    <message>
        <source>Slow to</source>
        <translation>Verlangsamen auf</translation>
    </message>
    <message>
        <source>Share of the planned speed while something asks to slow down.</source>
        <translation>Anteil der geplanten Geschwindigkeit, während etwas Verlangsamung verlangt.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>Expected a number up to %1, or −∞ for no limit.</source>
        <translation>Erwartet wird eine Zahl bis %1, oder −∞ für keine Grenze.</translation>
    </message>
    <message>
        <source>Expected a number above %1, or ∞ for no limit.</source>
        <translation>Erwartet wird eine Zahl über %1, oder ∞ für keine Grenze.</translation>
    </message>
    <message>
        <source>Expected a number from %1 on, or ∞ for no limit.</source>
        <translation>Erwartet wird eine Zahl ab %1, oder ∞ für keine Grenze.</translation>
    </message>
    <message>
        <source>Expected a number above %1 and at most %2.</source>
        <translation>Erwartet wird eine Zahl über %1 und höchstens %2.</translation>
    </message>
    <message>
        <source>Expected a number from %1 to %2.</source>
        <translation>Erwartet wird eine Zahl von %1 bis %2.</translation>
    </message>
    <message>
        <source>Or %1 numbers, one for each joint: 1; 2; …</source>
        <translation>Oder %1 Zahlen, eine für jedes Gelenk: 1; 2; …</translation>
    </message>
    <message>
        <source>%1 stood from %2 to %3 when this was played, %4: %5</source>
        <translation>%1 stand von %2 bis %3, als dies gespielt wurde, %4: %5</translation>
    </message>
    <message>
        <source>Poke link</source>
        <translation>Glied stoßen</translation>
    </message>
    <message>
        <source>Push the selected link away from the camera for half a second</source>
        <translation>Das gewählte Glied eine halbe Sekunde lang von der Kamera wegdrücken</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 from %2 to %3: %4</source>
        <translation>%1 von %2 bis %3: %4</translation>
    </message>
    <message>
        <source>touching, margin %1</source>
        <translation>Berührung, Sicherheitsabstand %1</translation>
    </message>
    <message>
        <source>%1 N, all pairs</source>
        <translation>%1 N, alle Paare</translation>
    </message>
    <message>
        <source>Virtual (margin) force</source>
        <translation>Virtuelle Kraft (Sicherheitsabstand)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>contact force %1 N</source>
        <translation>Kontaktkraft %1 N</translation>
    </message>
    <message>
        <source>virtual (margin) force %1 N</source>
        <translation>virtuelle Kraft (Sicherheitsabstand) %1 N</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>%1 and %2 touch</source>
        <translation>%1 und %2 berühren sich</translation>
    </message>
    <message>
        <source>%1 and %2 are inside the margin</source>
        <translation>%1 und %2 unterschreiten den Sicherheitsabstand</translation>
    </message>
    <message>
        <source>%1 and %2 are near each other, closer than twice the margin,</source>
        <translation>%1 und %2 sind einander nahe, näher als der doppelte Sicherheitsabstand,</translation>
    </message>
    <message>
        <source>The pose of %1 or %2 is lost</source>
        <translation>Die Pose von %1 oder %2 ist verloren</translation>
    </message>
    <message>
        <source>%1 and %2 are not checked: their group does not run, or they are in none</source>
        <translation>%1 und %2 werden nicht geprüft: Ihre Gruppe läuft nicht, oder sie sind in keiner</translation>
    </message>
    <message>
        <source>%1 and %2 are clear of each other</source>
        <translation>%1 und %2 sind frei voneinander</translation>
    </message>
    <message>
        <source>Nothing is known of %1 and %2 yet</source>
        <translation>Über %1 und %2 ist noch nichts bekannt</translation>
    </message>
    <message>
        <source> since %1</source>
        <translation> seit %1</translation>
    </message>
    <message>
        <source> since %1 or earlier</source>
        <translation> seit %1 oder früher</translation>
    </message>
    <message>
        <source>margin %1 and poses unknown</source>
        <translation>Sicherheitsabstand %1 und Posen unbekannt</translation>
    </message>
    <message>
        <source>margin %1 and %2 for the poses</source>
        <translation>Sicherheitsabstand %1 und %2 für die Posen</translation>
    </message>
    <message>
        <source>closing speed not known</source>
        <translation>Annäherung nicht bekannt</translation>
    </message>
    <message>
        <source>neither closing nor moving apart</source>
        <translation>weder Annäherung noch Entfernung</translation>
    </message>
    <message>
        <source>closing at %1 m/s</source>
        <translation>Annäherung mit %1 m/s</translation>
    </message>
    <message>
        <source>moving apart at %1 m/s</source>
        <translation>Entfernung mit %1 m/s</translation>
    </message>
    <message>
        <source>distance %1 ± %2</source>
        <translation>Abstand %1 ± %2</translation>
    </message>
    <message>
        <source>%1. When last checked: %2.</source>
        <translation>%1. Bei der letzten Prüfung: %2.</translation>
    </message>
    <message>
        <source>%1: %2, %3, %4, %5.</source>
        <translation>%1: %2, %3, %4, %5.</translation>
    </message>
    <message>
        <source>The pose is stale or was rejected: drawn hollow, never safe</source>
        <translation>Die Pose ist veraltet oder wurde verworfen: hohl gezeichnet, nie sicher</translation>
    </message>
    <message>
        <source>tracking lost</source>
        <translation>Verfolgung verloren</translation>
    </message>
    <message>
        <source>touching</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>robot stopped</source>
        <translation>Roboter gestoppt</translation>
    </message>
    <message>
        <source>Show contact forces and virtual (margin) forces as arrows</source>
        <translation>Kontaktkräfte und virtuelle Kräfte (Sicherheitsabstand) als Pfeile zeigen</translation>
    </message>
    <message>
        <source>Show torques of contacts and margins as curved arrows</source>
        <translation>Drehmomente von Kontakten und Sicherheitsabständen als gebogene Pfeile zeigen</translation>
    </message>
    <message>
        <source>Show what contacts and margins cause at each joint, as arrows about or along its axis</source>
        <translation>Wirkung von Kontakten und Sicherheitsabständen auf jedes Gelenk zeigen, als Pfeile um oder längs seiner Achse</translation>
    </message>
    <message>
        <source>Name bodies that touch or are inside a margin, and the selection</source>
        <translation>Körper benennen, die sich berühren oder einen Sicherheitsabstand unterschreiten, und die Auswahl</translation>
    </message>
    <message>
        <source>Go to the next event of the kinds that the events panel shows</source>
        <translation>Zum nächsten Ereignis der Arten gehen, die das Ereignisfeld zeigt</translation>
    </message>
    <message>
        <source>Go to the event before, of the kinds that the events panel shows</source>
        <translation>Zum vorigen Ereignis der Arten gehen, die das Ereignisfeld zeigt</translation>
    </message>
    <message>
        <source>Next &amp;touch</source>
        <translation>Nächste &amp;Berührung</translation>
    </message>
    <message>
        <source>Go to where a robot next touches a person</source>
        <translation>Zur nächsten Berührung eines Roboters mit einer Person gehen</translation>
    </message>
    <message>
        <source>Touch before</source>
        <translation>Vorige Berührung</translation>
    </message>
    <message>
        <source>Go to the touch before</source>
        <translation>Zur vorigen Berührung gehen</translation>
    </message>
    <message>
        <source>Next &amp;intrusion</source>
        <translation>Nächste &amp;Unterschreitung</translation>
    </message>
    <message>
        <source>Go to where a margin is next broken</source>
        <translation>Zur nächsten Unterschreitung eines Sicherheitsabstands gehen</translation>
    </message>
    <message>
        <source>Intrusion before</source>
        <translation>Vorige Unterschreitung</translation>
    </message>
    <message>
        <source>Go to the intrusion into a margin before</source>
        <translation>Zur vorigen Unterschreitung eines Sicherheitsabstands gehen</translation>
    </message>
    <message>
        <source>Next &amp;near miss</source>
        <translation>Nächste &amp;Annäherung</translation>
    </message>
    <message>
        <source>Go to the next near miss</source>
        <translation>Zur nächsten Annäherung gehen</translation>
    </message>
    <message>
        <source>Near miss before</source>
        <translation>Vorige Annäherung</translation>
    </message>
    <message>
        <source>Go to the near miss before</source>
        <translation>Zur vorigen Annäherung gehen</translation>
    </message>
    <message>
        <source>Next &amp;stop</source>
        <translation>Nächster &amp;Stopp</translation>
    </message>
    <message>
        <source>Go to where a robot next stopped, as far as it was played</source>
        <translation>Zum nächsten Stopp eines Roboters gehen, soweit abgespielt</translation>
    </message>
    <message>
        <source>Stop before</source>
        <translation>Voriger Stopp</translation>
    </message>
    <message>
        <source>Go to the stop of a robot before</source>
        <translation>Zum vorigen Stopp eines Roboters gehen</translation>
    </message>
    <message>
        <source>Next &amp;loss of tracking</source>
        <translation>Nächster &amp;Verlust der Verfolgung</translation>
    </message>
    <message>
        <source>Go to where body parts are next not seen</source>
        <translation>Dorthin gehen, wo als Nächstes Körperteile nicht gesehen werden</translation>
    </message>
    <message>
        <source>Loss of tracking before</source>
        <translation>Voriger Verlust der Verfolgung</translation>
    </message>
    <message>
        <source>Go to the loss of tracking before</source>
        <translation>Zum vorigen Verlust der Verfolgung gehen</translation>
    </message>
    <message>
        <source>Pause where an event of a shown kind begins, or a near miss is nearest</source>
        <translation>Anhalten, wo ein Ereignis einer gezeigten Art beginnt oder eine Annäherung am nächsten ist</translation>
    </message>
    <message>
        <source>touching, %1 N</source>
        <translation>berührt, %1 N</translation>
    </message>
    <message>
        <source>inside margin, virtual %1 N</source>
        <translation>unterschritten, virtuell %1 N</translation>
    </message>
    <message>
        <source>%1 and %2 are not certainly outside the margin</source>
        <translation>Bei %1 und %2 ist nicht sicher, dass der Sicherheitsabstand eingehalten ist,</translation>
    </message>
    <message numerus="yes">
        <source>%n unchecked pairs left out</source>
        <translation>
            <numerusform>%n nicht geprüftes Paar ausgelassen</numerusform>
            <numerusform>%n nicht geprüfte Paare ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Moments as they arrived; nothing is said about the time between them</source>
        <translation>Zeitpunkte, wie sie ankamen; über die Zeit dazwischen ist nichts gesagt</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Outcome of the present margins over the whole recording, as recorded and without
reactions: protective stops, and the share of time in which the robot would have stood.
False: even without the stop nobody would have been touched.
Missed: a touch before the robot stands is not excluded, or nobody told the robot.
The same numbers as those of &quot;abstand tune&quot;.</source>
        <translation>Ergebnis der jetzigen Sicherheitsabstände über die ganze Aufnahme, wie aufgenommen und ohne
Reaktionen: Sicherheitshalte, und der Anteil der Zeit, in der der Roboter gestanden hätte.
Fehlauslösung: Auch ohne den Halt wäre niemand berührt worden.
Verpasst: Eine Berührung vor dem Stillstand ist nicht ausgeschlossen, oder niemand sagte es dem Roboter.
Dieselben Zahlen wie die von „abstand tune“.</translation>
    </message>
    <message>
        <source>Assumed (Margins &gt; What-if assumptions): reaction time %1 s, deceleration %2 rad/s² or m/s²,
limit %3, restart time %4 s, calibration error %5, age of poses %6 s.</source>
        <translation>Angenommen (Sicherheitsabstände &gt; Annahmen): Reaktionszeit %1 s, Verzögerung %2 rad/s² oder m/s²,
einzuhaltender Abstand %3, Wiederanlaufzeit %4 s, Kalibrierfehler %5, Alter der Posen %6 s.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of people and robots are not checked, and are not part of it.</source>
        <translation>
            <numerusform>%n Paar aus Person und Roboter wird nicht geprüft und ist nicht dabei.</numerusform>
            <numerusform>%n Paare aus Person und Roboter werden nicht geprüft und sind nicht dabei.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was not opened: %2 at a time, and %3 is there.</source>
        <translation>%1 wurde nicht geöffnet: Gleichzeitig %2, und %3 ist schon da.</translation>
    </message>
    <message>
        <source>one project is shown</source>
        <translation>wird ein Projekt gezeigt</translation>
    </message>
    <message>
        <source>one scene is shown</source>
        <translation>wird eine Szene gezeigt</translation>
    </message>
    <message>
        <source>one set of margins holds</source>
        <translation>gilt ein Abstandssatz</translation>
    </message>
    <message>
        <source>one recording of a server is shown</source>
        <translation>wird eine Aufnahme eines Servers gezeigt</translation>
    </message>
    <message>
        <source>%1 was not found.</source>
        <translation>%1 wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>%1 is no file that this program opens: it opens projects (.abstand), scenes and margins (.yaml), robots (.urdf, .mech), meshes (%2) and recordings, which are folders of depth images and the files %3.</source>
        <translation>%1 ist keine Datei, die dieses Programm öffnet: Es öffnet Projekte (.abstand), Szenen und Abstandssätze (.yaml), Roboter (.urdf, .mech), Netze (%2) und Aufnahmen, nämlich Ordner mit Tiefenbildern und die Dateien %3.</translation>
    </message>
    <message>
        <source>%1 was not opened: the project %2 has a scene.</source>
        <translation>%1 wurde nicht geöffnet: Das Projekt %2 hat eine Szene.</translation>
    </message>
    <message>
        <source>%1 was not opened: the recording of a server is opened by itself.</source>
        <translation>%1 wurde nicht geöffnet: Die Aufnahme eines Servers wird für sich geöffnet.</translation>
    </message>
    <message>
        <source>Margins are proposed from a recording, not from the moments of a running server.</source>
        <translation>Sicherheitsabstände werden aus einer Aufnahme vorgeschlagen, nicht aus den Zeitpunkten eines laufenden Servers.</translation>
    </message>
    <message>
        <source>Open projects, scenes, robots, meshes and recordings; several at once become one scene</source>
        <translation>Projekte, Szenen, Roboter, Netze und Aufnahmen öffnen; mehrere zugleich werden eine Szene</translation>
    </message>
    <message>
        <source>Open depth folder…</source>
        <translation>Ordner mit Tiefenbildern öffnen…</translation>
    </message>
    <message>
        <source>Let the person move as in the depth images of a folder</source>
        <translation>Die Person bewegt sich wie in den Tiefenbildern eines Ordners</translation>
    </message>
    <message>
        <source>Propose sp&amp;eeds…</source>
        <translation>Geschwin&amp;digkeiten vorschlagen…</translation>
    </message>
    <message>
        <source>How fast the robots&apos; program may be in each of its segments, so that no limit is broken</source>
        <translation>Wie schnell das Programm der Roboter in jedem seiner Abschnitte sein darf, ohne eine Grenze zu verletzen</translation>
    </message>
    <message>
        <source>What-&amp;if assumptions…</source>
        <translation>Ann&amp;ahmen…</translation>
    </message>
    <message>
        <source>Reaction time, braking, limit and errors that lanes, events and report are judged with</source>
        <translation>Reaktionszeit, Bremsen, einzuhaltender Abstand und Fehler, mit denen Spuren, Ereignisse und Bericht beurteilt werden</translation>
    </message>
    <message>
        <source>Clearance &amp;limit</source>
        <translation>Einzuhaltender &amp;Abstand</translation>
    </message>
    <message>
        <source>Clearance that a moving robot must keep; 0: no contact</source>
        <translation>Abstand, den ein bewegter Roboter einhalten muss; 0: Er darf nicht berühren</translation>
    </message>
    <message>
        <source>&amp;Reaction time</source>
        <translation>Rea&amp;ktionszeit</translation>
    </message>
    <message>
        <source>From the frame that breaks a margin until the robot slows down: sensor, network and controller</source>
        <translation>Vom Bild, in dem der Sicherheitsabstand unterschritten wird, bis der Roboter bremst: Sensor, Netzwerk und Steuerung</translation>
    </message>
    <message>
        <source>&amp;Deceleration</source>
        <translation>&amp;Verzögerung</translation>
    </message>
    <message>
        <source>Of every joint, on the path of its motion</source>
        <translation>Jedes Gelenks, auf der Bahn seiner Bewegung</translation>
    </message>
    <message>
        <source>Re&amp;start time</source>
        <translation>&amp;Wiederanlaufzeit</translation>
    </message>
    <message>
        <source>From the end of an intrusion until the robot resumes</source>
        <translation>Vom Ende einer Unterschreitung, bis der Roboter weiterfährt</translation>
    </message>
    <message>
        <source>&amp;Calibration error</source>
        <translation>&amp;Kalibrierfehler</translation>
    </message>
    <message>
        <source>Largest error between the frames of recording and robots; part of every uncertainty</source>
        <translation>Größter Fehler zwischen den Koordinatensystemen von Aufnahme und Robotern; Teil jeder Unsicherheit</translation>
    </message>
    <message>
        <source>Age of &amp;poses</source>
        <translation>Alter der &amp;Posen</translation>
    </message>
    <message>
        <source>How old a person&apos;s pose is when it arrives</source>
        <translation>Wie alt die Pose einer Person ist, wenn sie ankommt</translation>
    </message>
    <message>
        <source>What-if assumptions</source>
        <translation>Annahmen</translation>
    </message>
    <message>
        <source>Lanes, events, margin curve, proposed margins and report are judged with these numbers of your cell; they are those of &quot;abstand tune&quot;. Another reaction time, deceleration, limit, calibration error or age of poses runs the analysis of the recording again.</source>
        <translation>Spuren, Ereignisse, Abstandskurve, vorgeschlagene Sicherheitsabstände und Bericht werden mit diesen Zahlen Ihrer Zelle beurteilt; es sind die von „abstand tune“. Mit anderer Reaktionszeit, Verzögerung, anderem einzuhaltenden Abstand, Kalibrierfehler oder Alter der Posen beginnt die Auswertung der Aufnahme neu.</translation>
    </message>
    <message>
        <source>A certified distance is below its limit.</source>
        <translation>Ein zertifizierter Abstand liegt unter seiner Grenze.</translation>
    </message>
    <message>
        <source>The robot is faster than the separation permits.</source>
        <translation>Der Roboter ist schneller, als es der Abstand erlaubt.</translation>
    </message>
    <message>
        <source>A link has more kinetic energy than the repulsion can absorb.</source>
        <translation>Ein Glied hat mehr Bewegungsenergie, als die Abstoßung aufnehmen kann.</translation>
    </message>
    <message>
        <source>The joint values are older than allowed.</source>
        <translation>Die Gelenkwerte sind älter als erlaubt.</translation>
    </message>
    <message>
        <source>The pose of a person is older than allowed, or unreliable.</source>
        <translation>Die Pose einer Person ist älter als erlaubt oder unzuverlässig.</translation>
    </message>
    <message>
        <source>The connection to the robot is lost.</source>
        <translation>Die Verbindung zum Roboter ist verloren.</translation>
    </message>
    <message>
        <source>A joint torque was limited.</source>
        <translation>Ein Gelenkmoment wurde begrenzt.</translation>
    </message>
    <message>
        <source>A joint is faster than allowed.</source>
        <translation>Ein Gelenk ist schneller als erlaubt.</translation>
    </message>
    <message>
        <source>A body was faster than the bound that certified distances rely on.</source>
        <translation>Ein Körper war schneller als die Schranke, auf der zertifizierte Abstände beruhen.</translation>
    </message>
    <message>
        <source>Somebody asks for a stop.</source>
        <translation>Jemand verlangt einen Halt.</translation>
    </message>
    <message>
        <source>While it brakes, a person could come nearer than allowed.</source>
        <translation>Während er bremst, könnte eine Person näher kommen als erlaubt.</translation>
    </message>
    <message>
        <source>no stop</source>
        <translation>kein Halt</translation>
    </message>
    <message>
        <source>slow down</source>
        <translation>verlangsamen</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm to the left of the view; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied in der Ansicht 10 mm nach links rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm to the right of the view; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied in der Ansicht 10 mm nach rechts rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm up in the view; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied in der Ansicht 10 mm nach oben rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm down in the view; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied in der Ansicht 10 mm nach unten rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm towards the camera; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied 10 mm zur Kamera hin rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Pose the robot so that the selected link moves 10 mm away from the camera; or move a thing</source>
        <translation>Den Roboter so stellen, dass das gewählte Glied 10 mm von der Kamera weg rückt; oder einen Gegenstand verschieben</translation>
    </message>
    <message>
        <source>Depth points</source>
        <translation>Tiefenpunkte</translation>
    </message>
    <message>
        <source>Draw the measured points of the depth images beside the fitted body and the robot</source>
        <translation>Die gemessenen Punkte der Tiefenbilder neben dem angepassten Körper und dem Roboter zeichnen</translation>
    </message>
    <message>
        <source>Depth points by confidence</source>
        <translation>Tiefenpunkte nach Sicherheit</translation>
    </message>
    <message>
        <source>Colour the points of a person by the state of the nearest joint instead of by person and robot</source>
        <translation>Die Punkte einer Person nach dem Zustand des nächsten Gelenks färben statt nach Person und Roboter</translation>
    </message>
    <message>
        <source>Depth points of all cameras</source>
        <translation>Tiefenpunkte aller Kameras</translation>
    </message>
    <message>
        <source>Draw the points of all cameras instead of those of the person in the panel Depth image</source>
        <translation>Die Punkte aller Kameras zeichnen statt derer der Person im Fenster Tiefenbild</translation>
    </message>
    <message>
        <source>%1, pose unknown</source>
        <translation>%1, Pose unbekannt</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>&amp;Verify the engine…</source>
        <translation>Rechenkern &amp;verifizieren…</translation>
    </message>
    <message>
        <source>Check distances and forces of this machine against brute force and closed forms</source>
        <translation>Abstände und Kräfte auf diesem Rechner gegen vollständige Suche und geschlossene Formeln prüfen</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Out of image</source>
        <translation>Außerhalb Bild</translation>
    </message>
    <message>
        <source>Out of range</source>
        <translation>Außerhalb Bereich</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Thing</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>Own body</source>
        <translation>Eigener Körper</translation>
    </message>
    <message>
        <source>Other person</source>
        <translation>Andere Person</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>not in the recording</source>
        <translation>nicht in der Aufnahme</translation>
    </message>
    <message>
        <source>outside of the image</source>
        <translation>außerhalb des Bildes</translation>
    </message>
    <message>
        <source>outside of the range of depths</source>
        <translation>außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>hidden by a robot</source>
        <translation>von einem Roboter verdeckt</translation>
    </message>
    <message>
        <source>hidden by a thing of the room</source>
        <translation>von einem Gegenstand im Raum verdeckt</translation>
    </message>
    <message>
        <source>hidden by the person&apos;s own body</source>
        <translation>vom eigenen Körper verdeckt</translation>
    </message>
    <message>
        <source>hidden by another person</source>
        <translation>von einer anderen Person verdeckt</translation>
    </message>
    <message>
        <source>%1: %2 from %3 to %4 (%5)</source>
        <translation>%1: %2 von %3 bis %4 (%5)</translation>
    </message>
    <message>
        <source>Plan a depth camera…</source>
        <translation>Tiefenkamera planen…</translation>
    </message>
    <message>
        <source>What a depth camera would not see of the people over the whole recording, and why</source>
        <translation>Was eine Tiefenkamera über die ganze Aufnahme von den Personen nicht sähe, und warum</translation>
    </message>
    <message>
        <source>Calibrate a depth camera…</source>
        <translation>Tiefenkamera kalibrieren…</translation>
    </message>
    <message>
        <source>Find the pose of a depth camera by the room, a person, a robot, a chessboard or points</source>
        <translation>Die Lage einer Tiefenkamera finden: mit dem Raum, einer Person, einem Roboter, einem Schachbrett oder Punkten</translation>
    </message>
    <message>
        <source>%1: %2 x %3 pixels, %4 to %5 m</source>
        <translation>%1: %2 x %3 Pixel, %4 bis %5 m</translation>
    </message>
    <message>
        <source>Open a live depth camera…</source>
        <translation>Live-Tiefenkamera öffnen…</translation>
    </message>
    <message>
        <source>Let a Kinect at this computer move the person of a scene, and show the distances</source>
        <translation>Die Person einer Szene von einer Kinect an diesem Rechner bewegen lassen und die Abstände zeigen</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Uhrzeit</translation>
    </message>
    <message>
        <source>Show when a moment was recorded, by the clock, instead of the time since the start</source>
        <translation>Die Uhrzeit der Aufnahme statt der Zeit seit dem Anfang zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n stops, %1 % of the time; %2 false, %3 missed</source>
        <translation>
            <numerusform>%n Stopp, %1 % der Zeit; Fehlauslösungen: %2, verpasste Stopps: %3</numerusform>
            <numerusform>%n Stopps, %1 % der Zeit; Fehlauslösungen: %2, verpasste Stopps: %3</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::Actions</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Spra&amp;che</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Opacity of people</source>
        <translation>Deckkraft von Personen</translation>
    </message>
    <message>
        <source>How solid people are drawn</source>
        <translation>Wie undurchsichtig Personen gezeichnet werden</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Margins</source>
        <translation>&amp;Sicherheitsabstände</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>Ka&amp;mera</translation>
    </message>
    <message>
        <source>Pan&amp;els</source>
        <translation>B&amp;ereiche</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Event of a &amp;kind</source>
        <translation>Ereignis &amp;je Art</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BackButton</name>
    <message>
        <source>%1: back to the scene file</source>
        <translation>%1: zurück zur Szenendatei</translation>
    </message>
    <message>
        <source>Back to the scene file: %1</source>
        <translation>Zurück zur Szenendatei: %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BoardFields</name>
    <message>
        <source>Squares along x</source>
        <translation>Felder entlang x</translation>
    </message>
    <message>
        <source>Squares along y</source>
        <translation>Felder entlang y</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BodyView</name>
    <message>
        <source>%1: %2 m, %3 kg</source>
        <translation>%1: %2 m, %3 kg</translation>
    </message>
    <message>
        <source>This person</source>
        <translation>Diese Person</translation>
    </message>
    <message>
        <source>Woman, 5th percentile</source>
        <translation>Frau, 5. Perzentil</translation>
    </message>
    <message>
        <source>Man, 95th percentile</source>
        <translation>Mann, 95. Perzentil</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BookmarkCommands</name>
    <message>
        <source>Bookmark</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Note for the bookmark at %1:</source>
        <translation>Notiz zum Lesezeichen bei %1:</translation>
    </message>
    <message>
        <source>bookmark at %1</source>
        <translation>Lesezeichen bei %1</translation>
    </message>
    <message>
        <source>remove bookmark</source>
        <translation>Lesezeichen entfernen</translation>
    </message>
    <message>
        <source>No bookmark at this frame</source>
        <translation>Kein Lesezeichen bei diesem Einzelbild</translation>
    </message>
    <message>
        <source>note of a bookmark</source>
        <translation>Notiz eines Lesezeichens</translation>
    </message>
    <message>
        <source>No later bookmark</source>
        <translation>Kein späteres Lesezeichen</translation>
    </message>
    <message>
        <source>No earlier bookmark</source>
        <translation>Kein früheres Lesezeichen</translation>
    </message>
    <message>
        <source>Bookmark at %1</source>
        <translation>Lesezeichen bei %1</translation>
    </message>
    <message>
        <source>Bookmark at %1: %2</source>
        <translation>Lesezeichen bei %1: %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BookmarkPanel</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Remove the chosen bookmark</source>
        <translation>Das gewählte Lesezeichen entfernen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::BookmarkTable</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CalibrationCommands</name>
    <message>
        <source>Save camera file</source>
        <translation>Kameradatei speichern</translation>
    </message>
    <message>
        <source>Camera files (*.yaml)</source>
        <translation>Kameradateien (*.yaml)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CalibrationDialog</name>
    <message>
        <source>Two cameras see the same room with surfaces in three directions, such as a floor and two walls. The first pose of this camera is within 0.2 m and 20 degrees.</source>
        <translation>Zwei Kameras sehen denselben Raum mit Flächen in drei Richtungen, etwa einen Boden und zwei Wände. Die erste Lage dieser Kamera stimmt auf 0,2 m und 20 Grad.</translation>
    </message>
    <message>
        <source>The camera and another one, or motion capture, record the same person at the same time, who walks about for some seconds. The clocks may differ by 5 s.</source>
        <translation>Die Kamera und eine andere, oder Motion Capture, nehmen zur selben Zeit dieselbe Person auf, die einige Sekunden umhergeht. Die Uhren dürfen um 5 s abweichen.</translation>
    </message>
    <message>
        <source>The camera sees a robot of the scene that is shown, at the times of the scene. The first pose of the camera is within 0.1 m and 10 degrees.</source>
        <translation>Die Kamera sieht einen Roboter der gezeigten Szene, zu den Zeiten der Szene. Die erste Lage der Kamera stimmt auf 0,1 m und 10 Grad.</translation>
    </message>
    <message>
        <source>Infrared or colour images of a chessboard whose place in the world is known: its origin is the inner corner at the dark corner square, x along the first side, z towards the viewer.</source>
        <translation>Infrarot- oder Farbbilder eines Schachbretts, dessen Ort in der Welt bekannt ist: Sein Ursprung ist die innere Ecke am dunklen Eckfeld, x entlang der ersten Seite, z zum Betrachter.</translation>
    </message>
    <message>
        <source>A table cx,cy,cz,wx,wy,wz of points that are known in the axes of the camera and in the world, in metres; three or more, not on one line.</source>
        <translation>Eine Tabelle cx,cy,cz,wx,wy,wz von Punkten, die in den Achsen der Kamera und in der Welt bekannt sind, in Metern; drei oder mehr, nicht auf einer Geraden.</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Verwendete Punkte</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>Größte Restabweichung</translation>
    </message>
    <message>
        <source>Surfaces that the other camera sees, too</source>
        <translation>Flächen, die auch die andere Kamera sieht</translation>
    </message>
    <message>
        <source>Agreement in the common view</source>
        <translation>Übereinstimmung im gemeinsamen Blickfeld</translation>
    </message>
    <message>
        <source>Visible surface of the robot that was found</source>
        <translation>Gefundene sichtbare Oberfläche des Roboters</translation>
    </message>
    <message>
        <source>Distance from the first pose</source>
        <translation>Abstand von der ersten Lage</translation>
    </message>
    <message>
        <source>Turn from the first pose</source>
        <translation>Drehung gegen die erste Lage</translation>
    </message>
    <message>
        <source>Offset of the clock</source>
        <translation>Versatz der Uhr</translation>
    </message>
    <message>
        <source>Way of the person</source>
        <translation>Weg der Person</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 in Zeile %2</translation>
    </message>
    <message>
        <source>%1 pixels in %2</source>
        <translation>%1 Pixel in %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The camera is at %1, %2, %3.</source>
        <translation>Die Kamera ist bei %1, %2, %3.</translation>
    </message>
    <message>
        <source>Its pose moves the points that it sees by %1 (standard deviation along an axis). Tracking adds this to the uncertainty of each joint, which widens the margins by at most %2.</source>
        <translation>Ihre Lage verschiebt die gesehenen Punkte um %1 (Standardabweichung entlang einer Achse). Die Verfolgung von Personen fügt das der Unsicherheit jedes Gelenks hinzu, was die Sicherheitsabstände um höchstens %2 vergrößert.</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>Calibrate a depth camera</source>
        <translation>Tiefenkamera kalibrieren</translation>
    </message>
    <message>
        <source>Quality of the calibration</source>
        <translation>Güte der Kalibrierung</translation>
    </message>
    <message>
        <source>The pose is being computed</source>
        <translation>Die Lage wird berechnet</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Berechnen</translation>
    </message>
    <message>
        <source>&amp;Save camera file…</source>
        <translation>Kameradatei &amp;speichern…</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Camera files (*.yaml *.yml)</source>
        <translation>Kameradateien (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Images (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>By the room that another camera sees, too</source>
        <translation>Mit dem Raum, den auch eine andere Kamera sieht</translation>
    </message>
    <message>
        <source>By a person whom another camera sees, too</source>
        <translation>Mit einer Person, die auch eine andere Kamera sieht</translation>
    </message>
    <message>
        <source>By the links of a robot of the scene</source>
        <translation>Mit den Gliedern eines Roboters der Szene</translation>
    </message>
    <message>
        <source>By images of a chessboard</source>
        <translation>Mit Bildern eines Schachbretts</translation>
    </message>
    <message>
        <source>By a table of points</source>
        <translation>Mit einer Tabelle von Punkten</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Methode</translation>
    </message>
    <message>
        <source>Depth &amp;recording of this camera</source>
        <translation>Tiefenauf&amp;nahme dieser Kamera</translation>
    </message>
    <message>
        <source>Recording &amp;known in the world</source>
        <translation>In der &amp;Welt bekannte Aufnahme</translation>
    </message>
    <message>
        <source>R&amp;obot</source>
        <translation>R&amp;oboter</translation>
    </message>
    <message>
        <source>&amp;Images</source>
        <translation>B&amp;ilder</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Brett</translation>
    </message>
    <message>
        <source>Table of &amp;points</source>
        <translation>&amp;Punkttabelle</translation>
    </message>
    <message>
        <source>Camera &amp;file</source>
        <translation>Kamera&amp;datei</translation>
    </message>
    <message>
        <source>With the lens of the camera, and its first pose where the method needs one; empty: as the depth recording says</source>
        <translation>Mit der Optik der Kamera, und ihrer ersten Lage, wo die Methode eine braucht; leer: wie in der Tiefenaufnahme</translation>
    </message>
    <message>
        <source>The scene that is shown has no robot.</source>
        <translation>Die gezeigte Szene hat keinen Roboter.</translation>
    </message>
    <message>
        <source>Computing the pose…</source>
        <translation>Die Lage wird berechnet…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Residual (RMS)</source>
        <translation>Restabweichung (RMS)</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>How far apart what the camera measures and what is known in the world remain; the noise of the camera is part of it</source>
        <translation>Wie weit das von der Kamera Gemessene und das in der Welt Bekannte auseinander bleiben; das Rauschen der Kamera ist ein Teil davon</translation>
    </message>
    <message>
        <source>Uncertainty of the pose</source>
        <translation>Unsicherheit der Lage</translation>
    </message>
    <message>
        <source>Standard deviation of the position of a seen point along an axis, due to the pose</source>
        <translation>Standardabweichung des Ortes eines gesehenen Punktes entlang einer Achse, durch die Lage</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ClassMarginRow</name>
    <message>
        <source>One margin for all pairs %1</source>
        <translation>Ein Sicherheitsabstand für alle Paare %1</translation>
    </message>
    <message>
        <source>One margin for all pairs %1, instead of the sums of two bodies&apos; margins</source>
        <translation>Ein Sicherheitsabstand für alle Paare %1 statt der Summen zweier Körper</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CloudCommands</name>
    <message>
        <source>No depth points: %1</source>
        <translation>Keine Tiefenpunkte: %1</translation>
    </message>
    <message>
        <source>The recordings of this scene have no depth images</source>
        <translation>Die Aufnahmen dieser Szene haben keine Tiefenbilder</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>%1 › %2</source>
        <translation>%1 › %2</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Wörter eines Befehls</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CompareLanes</name>
    <message>
        <source>as many %1</source>
        <translation>%1: gleich viele</translation>
    </message>
    <message>
        <source>%1 %2 more</source>
        <translation>%2: %1 mehr</translation>
    </message>
    <message>
        <source>%1 %2 fewer</source>
        <translation>%2: %1 weniger</translation>
    </message>
    <message>
        <source>%1 % of the time less</source>
        <translation>%1 % weniger Zeit</translation>
    </message>
    <message>
        <source>%1 % of the time more</source>
        <translation>%1 % mehr Zeit</translation>
    </message>
    <message>
        <source>A against B: %1, %2, %3, %4</source>
        <translation>A gegen B – %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>stops</source>
        <translation>Stopps</translation>
    </message>
    <message>
        <source>false</source>
        <translation>Fehlauslösungen</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>verpasste Stopps</translation>
    </message>
    <message>
        <source>Stops of two sets of margins</source>
        <translation>Stopps zweier Abstandssätze</translation>
    </message>
    <message>
        <source>Compare no longer</source>
        <translation>Nicht mehr vergleichen</translation>
    </message>
    <message>
        <source>A, the present margins: %1
B, the margins that were kept: %2
%3</source>
        <translation>A, die jetzigen Sicherheitsabstände: %1
B, die gemerkten Sicherheitsabstände: %2
%3</translation>
    </message>
    <message>
        <source>%1.  B: %2.  A: %3</source>
        <translation>%1.  B: %2.  A: %3</translation>
    </message>
    <message>
        <source>A: now</source>
        <translation>A: jetzt</translation>
    </message>
    <message>
        <source>B: kept</source>
        <translation>B: gemerkt</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CoverageCommands</name>
    <message>
        <source>planned depth camera</source>
        <translation>geplante Tiefenkamera</translation>
    </message>
    <message>
        <source>depth camera at the view</source>
        <translation>Tiefenkamera an die Ansicht</translation>
    </message>
    <message>
        <source>remove the depth camera</source>
        <translation>Tiefenkamera entfernen</translation>
    </message>
    <message>
        <source>Open camera file</source>
        <translation>Kameradatei öffnen</translation>
    </message>
    <message>
        <source>Camera files (*.yaml *.yml)</source>
        <translation>Kameradateien (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>depth camera of a file</source>
        <translation>Tiefenkamera einer Datei</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CoverageDialog</name>
    <message>
        <source>Every part is seen at all times.</source>
        <translation>Jeder Körperteil ist jederzeit zu sehen.</translation>
    </message>
    <message>
        <source>Least seen: %1, %2 % of the time.</source>
        <translation>Am wenigsten gesehen: %1, %2 % der Zeit.</translation>
    </message>
    <message>
        <source>Longest: %1.</source>
        <translation>Am längsten: %1.</translation>
    </message>
    <message>
        <source>Ten times per second, %1 x %2 pixels; robots follow their recorded motion.</source>
        <translation>Zehnmal in der Sekunde, %1 x %2 Pixel; Roboter folgen ihrer aufgezeichneten Bewegung.</translation>
    </message>
    <message>
        <source>What a depth camera would not see</source>
        <translation>Was eine Tiefenkamera nicht sähe</translation>
    </message>
    <message>
        <source>For how long body parts are hidden from a planned depth camera, and by what. Noise and unknown objects are not considered: a real camera sees less.</source>
        <translation>Wie lange Körperteile vor einer geplanten Tiefenkamera verdeckt sind, und wovon. Rauschen und unbekannte Gegenstände sind nicht berücksichtigt: Eine wirkliche Kamera sieht weniger.</translation>
    </message>
    <message>
        <source>Over the whole recording. A part counts as seen if at least 30 % of its surface towards the camera is seen, as in the tracking of people.</source>
        <translation>Über die ganze Aufnahme. Ein Körperteil gilt als gesehen, wenn mindestens 30 % seiner Oberfläche zur Kamera hin zu sehen sind, wie bei der Verfolgung von Personen.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Körperteil</translation>
    </message>
    <message>
        <source>When hidden</source>
        <translation>Wann verdeckt</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Längster</translation>
    </message>
    <message>
        <source>Share of the time: %1</source>
        <translation>Anteil der Zeit: %1</translation>
    </message>
    <message>
        <source>Time seen and hidden of each part</source>
        <translation>Gesehene und verdeckte Zeit jedes Körperteils</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>From the &amp;view</source>
        <translation>Von der Ans&amp;icht</translation>
    </message>
    <message>
        <source>Re&amp;move the sensor</source>
        <translation>Sensor ent&amp;fernen</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>The sensor stands where the 3D view is seen from, and looks in its direction</source>
        <translation>Der Sensor steht, von wo die 3D-Ansicht gesehen wird, und blickt in ihre Richtung</translation>
    </message>
    <message>
        <source>Opening the recording…</source>
        <translation>Aufnahme wird geöffnet…</translation>
    </message>
    <message>
        <source>Looking from the sensor…</source>
        <translation>Blick vom Sensor…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % of the surface towards the camera, on average</source>
        <translation>%1 % der Oberfläche zur Kamera hin, im Mittel</translation>
    </message>
    <message>
        <source>From a camera &amp;file…</source>
        <translation>Aus einer &amp;Kameradatei…</translation>
    </message>
    <message>
        <source>Lens and pose of a camera file, such as that of a calibration</source>
        <translation>Objektiv und Lage einer Kameradatei, etwa der einer Kalibrierung</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CoverageStrip</name>
    <message>
        <source>%1: seen at %2</source>
        <translation>%1: gesehen bei %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CurveArea</name>
    <message>
        <source>Share of time stopped, false and missed stops against the margin</source>
        <translation>Anteil des Stillstands, Fehlauslösungen und verpasste Stopps über dem Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Drag the handle to move the margin, as its slider does</source>
        <translation>Den Griff ziehen, um den Sicherheitsabstand zu ändern wie mit seinem Schieber</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>0 %</source>
        <translation>0 %</translation>
    </message>
    <message>
        <source>time stopped (left)</source>
        <translation>Stillstand (links)</translation>
    </message>
    <message>
        <source>false stops (right)</source>
        <translation>Fehlauslösungen (rechts)</translation>
    </message>
    <message>
        <source>missed stops (right)</source>
        <translation>verpasste Stopps (rechts)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::CyclePanel</name>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>&amp;Go to the longest</source>
        <translation>&amp;Zum längsten</translation>
    </message>
    <message>
        <source>Count &amp;anew</source>
        <translation>&amp;Neu zählen</translation>
    </message>
    <message>
        <source>Longest cycle of each frame</source>
        <translation>Längster Zyklus jedes Bildes</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Längster</translation>
    </message>
    <message>
        <source>Longer than 1 ms</source>
        <translation>Länger als 1 ms</translation>
    </message>
    <message>
        <source>Overruns</source>
        <translation>Überläufe</translation>
    </message>
    <message>
        <source>Cycles that took longer than the step that the loop had chosen for them</source>
        <translation>Zyklen, die länger dauerten als der Schritt, den die Schleife für sie gewählt hatte</translation>
    </message>
    <message>
        <source>Move to the moment of the longest cycle</source>
        <translation>Zum Zeitpunkt des längsten Zyklus gehen</translation>
    </message>
    <message>
        <source>Forget the cycles that were counted so far</source>
        <translation>Die bisher gezählten Zyklen vergessen</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>nothing was played</source>
        <translation>nichts abgespielt</translation>
    </message>
    <message>
        <source>Median, 99 %, 99.9 %</source>
        <translation>Median, 99 %, 99,9 %</translation>
    </message>
    <message>
        <source>Nearest then</source>
        <translation>Dabei am nächsten</translation>
    </message>
    <message>
        <source>Wall times that half, 99 % and 99.9 % of the played cycles kept</source>
        <translation>Zeiten, die die Hälfte, 99 % und 99,9 % der abgespielten Zyklen einhielten</translation>
    </message>
    <message>
        <source>%1, %2, %3 µs</source>
        <translation>%1, %2, %3 µs</translation>
    </message>
    <message>
        <source>%1 µs at %2</source>
        <translation>%1 µs bei %2</translation>
    </message>
    <message>
        <source>The nearest pair of the scene in the longest cycle: %1</source>
        <translation>Das nächste Paar der Szene im längsten Zyklus: %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::DepthPanel</name>
    <message>
        <source>The recordings of this scene have no depth images</source>
        <translation>Die Aufnahmen dieser Szene haben keine Tiefenbilder</translation>
    </message>
    <message>
        <source>Image %1 of %2, %3</source>
        <translation>Bild %1 von %2, %3</translation>
    </message>
    <message>
        <source>%1 (of a moment before)</source>
        <translation>%1 (von einem früheren Augenblick)</translation>
    </message>
    <message>
        <source>%1: the body was not found</source>
        <translation>%1: Körper nicht gefunden</translation>
    </message>
    <message>
        <source>%1
Camera of %2 pixels; body found in %3 of %4 images</source>
        <translation>%1
Kamera mit %2 Bildpunkten; Körper in %3 von %4 Bildern gefunden</translation>
    </message>
    <message>
        <source>Standard deviation of each joint along its worst axis</source>
        <translation>Standardabweichung jedes Gelenks entlang seiner ungünstigsten Achse</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>%1 tracked</source>
        <translation>%1 verfolgt</translation>
    </message>
    <message>
        <source>%1 inferred</source>
        <translation>%1 erschlossen</translation>
    </message>
    <message>
        <source>%1 not known</source>
        <translation>%1 nicht bekannt</translation>
    </message>
    <message>
        <source>Whose depth image</source>
        <translation>Wessen Tiefenbild</translation>
    </message>
    <message>
        <source>Image and camera</source>
        <translation>Bild und Kamera</translation>
    </message>
    <message>
        <source>States of the joints</source>
        <translation>Zustände der Gelenke</translation>
    </message>
</context>
<context>
    <name>abstand::ui::DepthView</name>
    <message>
        <source>Depth image</source>
        <translation>Tiefenbild</translation>
    </message>
</context>
<context>
    <name>abstand::ui::EventPanel</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>Arten von Ereignissen</translation>
    </message>
    <message>
        <source>Kinds of events that the table, the markers and the keys N and Shift+N show</source>
        <translation>Arten von Ereignissen, die Tabelle, Marken und die Tasten N und Umschalt+N zeigen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no events</source>
        <translation>keine Ereignisse</translation>
    </message>
</context>
<context>
    <name>abstand::ui::EventTableModel</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>When it begins</source>
        <translation>Wann es beginnt</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>How long it lasts</source>
        <translation>Wie lange es dauert</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Körperteil</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>The nearest link of a robot</source>
        <translation>Das nächste Glied eines Roboters</translation>
    </message>
    <message>
        <source>Smallest clearance</source>
        <translation>Gesicherter Abstand</translation>
    </message>
    <message>
        <source>Certified: the true distance was never below it, had the robot not stopped</source>
        <translation>Kleinster gesicherter Abstand: Der wahre Abstand war nie kleiner, hätte der Roboter nicht angehalten</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>By how much the measured distance may be too large: engine and pose</source>
        <translation>Um wie viel der gemessene Abstand zu groß sein kann: Rechenkern und Pose</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of the nearest points towards each other at the smallest clearance; negative: they move apart</source>
        <translation>Geschwindigkeit, mit der die nächsten Punkte beim kleinsten Abstand aufeinander zugehen; negativ: Sie entfernen sich</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Outcome of a stop at the beginning. Missed: too late, or not triggered;
false: not needed; empty: needed and in time</source>
        <translation>Was ein Stopp am Anfang gewesen wäre. Verpasst: zu spät, oder niemand hat es gemeldet;
Fehlauslösung: nicht nötig; leer: nötig und rechtzeitig</translation>
    </message>
    <message>
        <source>Touching: it is not certain that the surfaces are apart; inside margin: nothing touches;
touch between frames: two frames outside of the margin between which a touch is not excluded;
near miss: nearer than twice the margin, never inside;
robot stopped: as it was played; tracking lost: body parts that are not seen or whose poses are old</source>
        <translation>Berührung: Es ist nicht sicher, dass die Oberflächen getrennt sind; Unterschreitung: nichts berührt sich;
Berührung zwischen Bildern: zwei Bilder ohne Unterschreitung, zwischen denen eine Berührung nicht ausgeschlossen ist;
Annäherung: näher als der doppelte Sicherheitsabstand, nie unterschritten;
Roboter gestoppt: wie abgespielt; Verfolgung verloren: Körperteile, die nicht gesehen werden oder deren Posen alt sind</translation>
    </message>
    <message>
        <source>The part of the person, or the robot that stopped</source>
        <translation>Der Körperteil der Person, oder der gestoppte Roboter</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ExchangeCommands</name>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Whose recording?</source>
        <translation>Wessen Aufnahme?</translation>
    </message>
    <message>
        <source>Save range as recording</source>
        <translation>Bereich als Aufnahme speichern</translation>
    </message>
    <message>
        <source>Recordings (*.rec)</source>
        <translation>Aufnahmen (*.rec)</translation>
    </message>
    <message>
        <source>Of which robot?</source>
        <translation>Von welchem Roboter?</translation>
    </message>
    <message>
        <source>Open pairs of %1</source>
        <translation>Paare von %1 öffnen</translation>
    </message>
    <message>
        <source>SRDF (*.srdf)</source>
        <translation>SRDF-Dateien (*.srdf)</translation>
    </message>
    <message>
        <source>Save pairs of %1</source>
        <translation>Paare von %1 speichern</translation>
    </message>
</context>
<context>
    <name>abstand::ui::FileCommands</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Cannot open</source>
        <translation>Öffnen nicht möglich</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Open depth images</source>
        <translation>Tiefenbilder öffnen</translation>
    </message>
    <message>
        <source>Not opened</source>
        <translation>Nicht geöffnet</translation>
    </message>
</context>
<context>
    <name>abstand::ui::GhostView</name>
    <message>
        <source>Skeleton as it is read, from the front and from the side</source>
        <translation>Skelett, wie es gelesen wird, von vorn und von der Seite</translation>
    </message>
    <message>
        <source>No joints are known at this moment</source>
        <translation>In diesem Moment ist kein Gelenk bekannt</translation>
    </message>
    <message>
        <source>along x</source>
        <translation>entlang x</translation>
    </message>
    <message>
        <source>along y</source>
        <translation>entlang y</translation>
    </message>
</context>
<context>
    <name>abstand::ui::GroupPanel</name>
    <message>
        <source>R&amp;un</source>
        <translation>&amp;Laufen lassen</translation>
    </message>
    <message>
        <source>Pau&amp;se</source>
        <translation>Pa&amp;use</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Remo&amp;ve pair</source>
        <translation>Paar e&amp;ntfernen</translation>
    </message>
    <message>
        <source>A&amp;dd pair to</source>
        <translation>Paar hin&amp;zufügen zu</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Groups of pairs</source>
        <translation>Gruppen von Paaren</translation>
    </message>
    <message>
        <source>Check the pairs of the selected groups in every cycle</source>
        <translation>Die Paare der gewählten Gruppen in jedem Zyklus prüfen</translation>
    </message>
    <message>
        <source>Check them no more until they run again; robots with such pairs stop</source>
        <translation>Sie nicht mehr prüfen, bis sie wieder laufen; Roboter mit solchen Paaren halten an</translation>
    </message>
    <message>
        <source>The same, said to be for good</source>
        <translation>Dasselbe, aber als dauerhaft bezeichnet</translation>
    </message>
    <message>
        <source>Take the selected pairs out of their groups</source>
        <translation>Die gewählten Paare aus ihren Gruppen nehmen</translation>
    </message>
    <message>
        <source>Put the selected pairs, which are in no group, into a group</source>
        <translation>Die gewählten Paare, die in keiner Gruppe sind, in eine Gruppe aufnehmen</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>No pairs are checked.</source>
        <translation>Es werden keine Paare geprüft.</translation>
    </message>
    <message>
        <source>In no group</source>
        <translation>In keiner Gruppe</translation>
    </message>
    <message>
        <source>removed: stale</source>
        <translation>entfernt: veraltet</translation>
    </message>
    <message>
        <source>All %1 pairs are checked.</source>
        <translation>Alle %1 Paare werden geprüft.</translation>
    </message>
    <message>
        <source>⚠ %1 of %2 pairs are not checked: their distances are stale.</source>
        <translation>⚠ %1 von %2 Paaren werden nicht geprüft: Ihre Abstände sind veraltet.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::HistoryPanel</name>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Edits of the project</source>
        <translation>Änderungen des Projekts</translation>
    </message>
    <message>
        <source>A click goes back to the state after this edit, or forward to it</source>
        <translation>Ein Klick geht zum Stand nach dieser Änderung zurück oder vor</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ImportCommands</name>
    <message>
        <source>Import recording</source>
        <translation>Aufnahme importieren</translation>
    </message>
    <message>
        <source>import recording %1</source>
        <translation>Aufnahme %1 importieren</translation>
    </message>
    <message>
        <source>Save joint map</source>
        <translation>Gelenkzuordnung speichern</translation>
    </message>
    <message>
        <source>Joint maps (*.map)</source>
        <translation>Gelenkzuordnungen (*.map)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>axes: the file&apos;s axes are left-handed; sides: left and right are exchanged</source>
        <translation>axes: die Achsen der Datei sind linkshändig; sides: links und rechts sind vertauscht</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>in der Datei</translation>
    </message>
    <message>
        <source>Which joint of the file is which</source>
        <translation>Welches Gelenk der Datei welches ist</translation>
    </message>
    <message>
        <source>Time of the skeleton</source>
        <translation>Zeit des Skeletts</translation>
    </message>
    <message>
        <source>&amp;Units of the file</source>
        <translation>&amp;Einheiten der Datei</translation>
    </message>
    <message>
        <source>Axis that points u&amp;p</source>
        <translation>Achse, die nach &amp;oben zeigt</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>&amp;Spiegeln</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>wie gefunden</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Joint %1 in the file</source>
        <translation>Gelenk %1 in der Datei</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>%1 (guessed)</source>
        <translation>%1 (geraten)</translation>
    </message>
    <message>
        <source>%1, %2 s, %3 frames</source>
        <translation>%1, %2 s, %3 Einzelbilder</translation>
    </message>
    <message>
        <source>units %1, up %2, left and right: %3</source>
        <translation>Einheiten %1, oben %2, links und rechts: %3</translation>
    </message>
    <message>
        <source>stature %1; joints by %2</source>
        <translation>Körpergröße %1; Gelenke nach %2</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>no map</source>
        <translation>keiner Zuordnung</translation>
    </message>
    <message>
        <source>⚠ nothing moves: %1</source>
        <translation>⚠ nichts bewegt: %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::InspectorPanel</name>
    <message>
        <source>Properties of what is selected</source>
        <translation>Eigenschaften der Auswahl</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Select a body, a robot or a person in the 3D view or in the scene tree.</source>
        <translation>Einen Körper, einen Roboter oder eine Person in der 3D-Ansicht oder im Szenenbaum auswählen.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Place and person</source>
        <translation>Ort und Person</translation>
    </message>
</context>
<context>
    <name>abstand::ui::JointEditor</name>
    <message>
        <source>Follow the motion</source>
        <translation>Der Bewegung folgen</translation>
    </message>
    <message>
        <source>While a robot is posed by hand, the clock continues for everything else and its reaction is suspended.
Lanes, events and reports stay those of its recorded motion.</source>
        <translation>Solange ein Roboter von Hand gestellt ist, läuft die Uhr für alles andere weiter, und seine Reaktion ruht.
Spuren, Ereignisse und Berichte bleiben die seiner aufgezeichneten Bewegung.</translation>
    </message>
    <message>
        <source>Ends the posing by hand. Robots that react begin anew on their planned motion</source>
        <translation>Beendet das Stellen von Hand. Reagierende Roboter beginnen neu auf ihrer geplanten Bewegung</translation>
    </message>
    <message>
        <source>%1 is not posed by hand</source>
        <translation>%1 ist nicht von Hand gestellt</translation>
    </message>
    <message>
        <source>%1 is posed by hand</source>
        <translation>%1 ist von Hand gestellt</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Put the joints of the robot on the clipboard (rad, m)</source>
        <translation>Die Gelenke des Roboters in die Zwischenablage legen (rad, m)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::JointRow</name>
    <message>
        <source>Joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>Joint %1, slider</source>
        <translation>Gelenk %1, Regler</translation>
    </message>
    <message>
        <source>Poses the robot by hand: it no longer follows its motion</source>
        <translation>Stellt den Roboter von Hand: er folgt nicht mehr seiner Bewegung</translation>
    </message>
    <message>
        <source>Value of joint %1</source>
        <translation>Wert von Gelenk %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::KeyEditor</name>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Zuweisen</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Vorgabe</translation>
    </message>
    <message>
        <source>A&amp;ll default keys</source>
        <translation>A&amp;lle Vorgabetasten</translation>
    </message>
    <message>
        <source>Change keys</source>
        <translation>Tasten ändern</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Wörter eines Befehls</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>&amp;New key</source>
        <translation>&amp;Neue Taste</translation>
    </message>
    <message>
        <source>%1 › %2</source>
        <translation>%1 › %2</translation>
    </message>
    <message>
        <source>%1 is taken from “%2”.</source>
        <translation>%1 wird „%2“ weggenommen.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LaneView</name>
    <message>
        <source>Distance of each body part to the robots over time</source>
        <translation>Abstand jedes Körperteils zu den Robotern über der Zeit</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LawRow</name>
    <message>
        <source>No unit.</source>
        <translation>Keine Einheit.</translation>
    </message>
    <message>
        <source>Unit: %1.</source>
        <translation>Einheit: %1.</translation>
    </message>
    <message>
        <source>In scene files: %1; in this one: %2.</source>
        <translation>In Szenendateien: %1; in dieser: %2.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LinkDrag</name>
    <message>
        <source>Only links of robots can be moved</source>
        <translation>Nur Glieder von Robotern lassen sich bewegen</translation>
    </message>
    <message>
        <source>No joint moves this link</source>
        <translation>Kein Gelenk bewegt dieses Glied</translation>
    </message>
    <message>
        <source>move a link of %1</source>
        <translation>Ein Glied von %1 bewegen</translation>
    </message>
    <message>
        <source>Out of reach by %1: a joint limit or the length of the arm</source>
        <translation>Um %1 außer Reichweite: eine Gelenkgrenze oder die Länge des Arms</translation>
    </message>
    <message>
        <source>A thing is moved by its handles, once it is selected</source>
        <translation>Ein Gegenstand wird an seinen Griffen bewegt, sobald er ausgewählt ist</translation>
    </message>
    <message>
        <source>Select one link of a robot, or one thing, first</source>
        <translation>Zuerst ein Glied eines Roboters oder einen Gegenstand wählen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LinkPoke</name>
    <message>
        <source>Only links of robots can be poked</source>
        <translation>Nur Glieder von Robotern lassen sich stoßen</translation>
    </message>
    <message>
        <source>%1 cannot react to a poke: the scene file gives it no reaction</source>
        <translation>%1 kann auf einen Stoß nicht reagieren: die Szenendatei gibt ihm keine Reaktion</translation>
    </message>
    <message>
        <source>%1 cannot react to a poke: %2</source>
        <translation>%1 kann auf einen Stoß nicht reagieren: %2</translation>
    </message>
    <message>
        <source>%1 does not react to a poke: React is off</source>
        <translation>%1 reagiert nicht auf einen Stoß: Reagieren ist aus</translation>
    </message>
    <message>
        <source>%1 does not react to a poke: it is posed by hand</source>
        <translation>%1 reagiert nicht auf einen Stoß: er ist von Hand gestellt</translation>
    </message>
    <message>
        <source>No joint moves this link</source>
        <translation>Kein Gelenk bewegt dieses Glied</translation>
    </message>
    <message>
        <source>%1 does not yield to a poke: its law Torque is off (panel Laws)</source>
        <translation>%1 weicht einem Stoß nicht aus: sein Regelgesetz Moment ist aus (Feld Regelgesetze)</translation>
    </message>
    <message>
        <source>%1 does not yield to a poke: reaction torques are off</source>
        <translation>%1 weicht einem Stoß nicht aus: die Reaktionsmomente sind aus</translation>
    </message>
    <message>
        <source>%1 does not yield to a poke: its brakes are engaged</source>
        <translation>%1 weicht einem Stoß nicht aus: seine Bremsen sind eingefallen</translation>
    </message>
    <message>
        <source>Poke: press Play to see the robot yield</source>
        <translation>Stoß: Wiedergabe starten, um den Roboter ausweichen zu sehen</translation>
    </message>
    <message>
        <source>Select one link of a robot first</source>
        <translation>Zuerst ein Glied eines Roboters auswählen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LiveCameraDialog</name>
    <message>
        <source>Camera files (*.yaml *.yml)</source>
        <translation>Kameradateien (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Open a live depth camera</source>
        <translation>Live-Tiefenkamera öffnen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>S&amp;tart</source>
        <translation>S&amp;tarten</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>St&amp;opp</translation>
    </message>
    <message>
        <source>Name in the scene of the person whom the camera sees</source>
        <translation>Name der von der Kamera gesehenen Person in der Szene</translation>
    </message>
    <message>
        <source>measured in the first images</source>
        <translation>in den ersten Bildern gemessen</translation>
    </message>
    <message>
        <source>Height of the person; a known height needs no measurement</source>
        <translation>Körpergröße der Person; eine bekannte Größe muss nicht gemessen werden</translation>
    </message>
    <message>
        <source>With the pose of the camera in the world of the scene: View, Calibrate a depth camera</source>
        <translation>Mit der Lage der Kamera in der Welt der Szene: Ansicht, Tiefenkamera kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Scene</source>
        <translation>&amp;Szene</translation>
    </message>
    <message>
        <source>Camera &amp;file</source>
        <translation>Kamera&amp;datei</translation>
    </message>
    <message>
        <source>&amp;Person</source>
        <translation>&amp;Person</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>&amp;Robots stand still where their motion begins</source>
        <translation>&amp;Roboter stehen still, wo ihre Bewegung beginnt</translation>
    </message>
    <message>
        <source>The distances hold only if that is so: nothing measures the robots</source>
        <translation>Die Abstände gelten nur, wenn das so ist: Nichts misst die Roboter</translation>
    </message>
    <message>
        <source>One or two Kinects v1 at this computer move the person of a scene. Robots are lost until a program sends their joint values, unless they stand still.</source>
        <translation>Eine oder zwei Kinect v1 an diesem Rechner bewegen die Person einer Szene. Die Lage von Robotern gilt als verloren, bis ein Programm ihre Gelenkwerte sendet, außer sie stehen still.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Camera file of the second Kinect in the order of the driver; both are fitted together</source>
        <translation>Kameradatei der zweiten Kinect in der Reihenfolge des Treibers; beide Bilder werden gemeinsam ausgewertet</translation>
    </message>
    <message>
        <source>Seco&amp;nd camera</source>
        <translation>&amp;Zweite Kamera</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LiveCommands</name>
    <message>
        <source>Save the recording</source>
        <translation>Die Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recorded moments (*.moments)</source>
        <translation>Aufgezeichnete Momente (*.moments)</translation>
    </message>
    <message>
        <source>The server decides this; here it is only shown.</source>
        <translation>Darüber entscheidet der Server; hier wird es nur gezeigt.</translation>
    </message>
    <message>
        <source>%1
Not here: what is shown comes from a server, which decides.</source>
        <translation>%1
Hier nicht: Was gezeigt wird, kommt von einem Server, und der entscheidet.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::LogPanel</name>
    <message>
        <source>Only problems</source>
        <translation>Nur Probleme</translation>
    </message>
    <message>
        <source>Messages of the window</source>
        <translation>Meldungen des Fensters</translation>
    </message>
    <message>
        <source>No messages</source>
        <translation>Keine Meldungen</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Put all messages on the clipboard</source>
        <translation>Alle Meldungen in die Zwischenablage legen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MainWindow</name>
    <message>
        <source>Robots were restarted on their planned motion at %1</source>
        <translation>Roboter wurden bei %1 auf ihrer geplanten Bewegung neu gestartet</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>opacity of people</source>
        <translation>Deckkraft von Personen</translation>
    </message>
    <message>
        <source>view: %1 on</source>
        <translation>Ansicht: %1 ein</translation>
    </message>
    <message>
        <source>view: %1 off</source>
        <translation>Ansicht: %1 aus</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message numerus="yes">
        <source>The project has settings for %n names that the scene does not have. They have no effect:
%1</source>
        <translation>
            <numerusform>Das Projekt hat Einstellungen für %n Namen, den die Szene nicht hat. Sie bewirken nichts:
%1</numerusform>
            <numerusform>Das Projekt hat Einstellungen für %n Namen, die die Szene nicht hat. Sie bewirken nichts:
%1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Abstand</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1[*] – Abstand</source>
        <translation>%1[*] – Abstand</translation>
    </message>
    <message>
        <source>Autosave</source>
        <translation>Automatische Sicherung</translation>
    </message>
    <message>
        <source>Work is not kept for the case of a crash:
%1</source>
        <translation>Die Arbeit wird für den Fall eines Absturzes nicht aufbewahrt:
%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>recording options</source>
        <translation>Aufnahmeoptionen</translation>
    </message>
    <message>
        <source>%1, %2 posed by hand</source>
        <translation>%1, %2 von Hand gestellt</translation>
    </message>
    <message>
        <source>Opened %1: %2 bodies, %3 pairs</source>
        <translation>%1 geöffnet: %2 Körper, %3 Paare</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>Trennungsabstand</translation>
    </message>
    <message>
        <source>Select a body or a pair first</source>
        <translation>Erst einen Körper oder ein Paar auswählen</translation>
    </message>
    <message>
        <source> Select a body to see it.</source>
        <translation> Einen Körper auswählen, um es zu sehen.</translation>
    </message>
    <message>
        <source>Inside of the selection: nothing</source>
        <translation>Inneres der Auswahl: nichts</translation>
    </message>
    <message>
        <source>Inside of the selection: shell points.</source>
        <translation>Inneres der Auswahl: Hüllpunkte.</translation>
    </message>
    <message>
        <source>Inside of the selection: spheres of the tree, level %1.</source>
        <translation>Inneres der Auswahl: Kugeln des Baums, Ebene %1.</translation>
    </message>
    <message>
        <source>Inside of the selection: distances on a plane through its middle, dark from 50 mm on; pink: inside.</source>
        <translation>Inneres der Auswahl: Abstände auf einer Ebene durch die Mitte, dunkel ab 50 mm; rosa: innen.</translation>
    </message>
    <message>
        <source>what-if assumptions</source>
        <translation>Annahmen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginCommands</name>
    <message>
        <source>margin of %1</source>
        <translation>Sicherheitsabstand von %1</translation>
    </message>
    <message numerus="yes">
        <source>margins of %n objects</source>
        <translation>
            <numerusform>Sicherheitsabstand von %n Objekt</numerusform>
            <numerusform>Sicherheitsabstände von %n Objekten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n locked margins stay as they are</source>
        <translation>
            <numerusform>%n gesperrter Sicherheitsabstand bleibt, wie er ist</numerusform>
            <numerusform>%n gesperrte Sicherheitsabstände bleiben, wie sie sind</numerusform>
        </translation>
    </message>
    <message>
        <source>all margins %1 mm</source>
        <translation>alle Sicherheitsabstände %1 mm</translation>
    </message>
    <message>
        <source>no margins</source>
        <translation>keine Sicherheitsabstände</translation>
    </message>
    <message>
        <source>reset margins</source>
        <translation>Sicherheitsabstände zurücksetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n margins</source>
        <translation>
            <numerusform>%n Sicherheitsabstand</numerusform>
            <numerusform>%n Sicherheitsabstände</numerusform>
        </translation>
    </message>
    <message>
        <source>lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>unlock %1</source>
        <translation>%1 entsperren</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Sicherheitsabstände</translation>
    </message>
    <message>
        <source>A set of margins is for pairs of a person and a robot, and the scene has none.</source>
        <translation>Ein Abstandssatz gilt für Paare aus einer Person und einem Roboter, und die Szene hat keine.</translation>
    </message>
    <message>
        <source>Of several people the set has the largest margin of each part</source>
        <translation>Von mehreren Personen hat der Abstandssatz den größten Sicherheitsabstand jedes Körperteils</translation>
    </message>
    <message>
        <source>No set of margins for this scene</source>
        <translation>Kein Abstandssatz für diese Szene</translation>
    </message>
    <message>
        <source>The margins of people and robots are on the clipboard</source>
        <translation>Die Sicherheitsabstände von Personen und Robotern liegen in der Zwischenablage</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>paste margins</source>
        <translation>Sicherheitsabstände einfügen</translation>
    </message>
    <message>
        <source>Open margins</source>
        <translation>Sicherheitsabstände öffnen</translation>
    </message>
    <message>
        <source>Sets of margins (*.yaml *.yml)</source>
        <translation>Abstandssätze (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>margins of %1</source>
        <translation>Sicherheitsabstände von %1</translation>
    </message>
    <message>
        <source>Cannot open the margins</source>
        <translation>Die Sicherheitsabstände können nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Save margins</source>
        <translation>Sicherheitsabstände speichern</translation>
    </message>
    <message>
        <source>Sets of margins (*.yaml)</source>
        <translation>Abstandssätze (*.yaml)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Cannot save the margins</source>
        <translation>Die Sicherheitsabstände können nicht gespeichert werden</translation>
    </message>
    <message>
        <source>compare margins</source>
        <translation>Sicherheitsabstände vergleichen</translation>
    </message>
    <message>
        <source>compare margins no longer</source>
        <translation>Sicherheitsabstände nicht mehr vergleichen</translation>
    </message>
    <message>
        <source>Propose margins</source>
        <translation>Sicherheitsabstände vorschlagen</translation>
    </message>
    <message>
        <source>proposed margins</source>
        <translation>vorgeschlagene Sicherheitsabstände</translation>
    </message>
    <message>
        <source>margin of the pairs %1</source>
        <translation>Sicherheitsabstand der Paare %1</translation>
    </message>
    <message>
        <source>The margin of all pairs of people and robots is locked. Proposed margins are for single parts and would have no effect.</source>
        <translation>Der Sicherheitsabstand aller Paare von Personen und Robotern ist gesperrt. Vorgeschlagene Abstände gelten für einzelne Teile und hätten keine Wirkung.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginCurve</name>
    <message>
        <source>Body part of the curve</source>
        <translation>Körperteil der Kurve</translation>
    </message>
    <message>
        <source>The body part whose margin is varied; also set by the selection</source>
        <translation>Der Körperteil, dessen Sicherheitsabstand verändert wird; auch die Auswahl bestimmt ihn</translation>
    </message>
    <message>
        <source>This part alone, with the present margins of the links: the result of &quot;abstand tune&quot; for the part</source>
        <translation>Dieser Körperteil allein, mit den jetzigen Sicherheitsabständen der Glieder: was „abstand tune“ von ihm sagt</translation>
    </message>
    <message>
        <source>There is a curve where a scene has a person and a robot</source>
        <translation>Eine Kurve gibt es, wo eine Szene eine Person und einen Roboter hat</translation>
    </message>
    <message>
        <source>The analysis of the recording failed</source>
        <translation>Die Auswertung der Aufnahme ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>After the analysis of the recording (%1 %)</source>
        <translation>Nach der Auswertung der Aufnahme (%1 %)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is a curve of a recording, not of a running server</source>
        <translation>Eine Kurve gibt es von einer Aufnahme, nicht von einem laufenden Server</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginPanel</name>
    <message>
        <source>Safety margins</source>
        <translation>Sicherheitsabstände</translation>
    </message>
    <message>
        <source>Classes of pairs</source>
        <translation>Klassen von Paaren</translation>
    </message>
    <message>
        <source>A ticked class has one margin for all of its pairs, instead of the sums of two bodies&apos; margins</source>
        <translation>Eine angekreuzte Klasse hat einen Sicherheitsabstand für alle ihre Paare statt der Summen zweier Körper</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginRow</name>
    <message>
        <source>Margin of %1, slider</source>
        <translation>Sicherheitsabstand von %1, Schieber</translation>
    </message>
    <message>
        <source>Safety margin around %1</source>
        <translation>Sicherheitsabstand um %1</translation>
    </message>
    <message>
        <source>Lock the margin of %1</source>
        <translation>Sicherheitsabstand von %1 sperren</translation>
    </message>
    <message>
        <source>Lock: sliders, presets, pasted and proposed margins leave %1 alone</source>
        <translation>Sperren: Schieber, Vorgaben, eingefügte und vorgeschlagene Sicherheitsabstände lassen %1 unverändert</translation>
    </message>
    <message>
        <source>Margin of %1</source>
        <translation>Sicherheitsabstand von %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::MarginTools</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search margins by name</source>
        <translation>Sicherheitsabstände nach Namen suchen</translation>
    </message>
    <message>
        <source>Shows only margins of parts, links and groups with this in their names; the slider of a group moves
only the margins that are shown</source>
        <translation>Zeigt nur Sicherheitsabstände von Körperteilen, Gliedern und Gruppen mit diesem Text im Namen; der Schieber
einer Gruppe ändert nur die gezeigten Sicherheitsabstände</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Set all margins that are not locked</source>
        <translation>Alle Sicherheitsabstände setzen, die nicht gesperrt sind</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Abstandssätze</translation>
    </message>
    <message>
        <source>Copy, save, propose and compare margins</source>
        <translation>Sicherheitsabstände kopieren, speichern, vorschlagen und vergleichen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::NotePanel</name>
    <message>
        <source>⚠ fails check</source>
        <translation>⚠ besteht check nicht</translation>
    </message>
    <message>
        <source>⚠ fails check --strict</source>
        <translation>⚠ besteht check --strict nicht</translation>
    </message>
    <message>
        <source>to know</source>
        <translation>zu wissen</translation>
    </message>
    <message>
        <source>Reservations</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Was nicht bekannt ist</translation>
    </message>
    <message>
        <source>⚠ Reservations (%1)</source>
        <translation>⚠ Zweifel (%1)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PairMatrix</name>
    <message>
        <source>People and robots</source>
        <translation>Personen und Roboter</translation>
    </message>
    <message>
        <source>All bodies</source>
        <translation>Alle Körper</translation>
    </message>
    <message>
        <source>Bodies of the matrix</source>
        <translation>Körper der Matrix</translation>
    </message>
    <message>
        <source>Matrix of the pairs</source>
        <translation>Matrix der Paare</translation>
    </message>
    <message>
        <source>%1 checked, %2 not</source>
        <translation>%1 geprüft, %2 nicht</translation>
    </message>
    <message>
        <source>Ticked: checked, with the distance; hatched: not checked</source>
        <translation>Mit Häkchen: geprüft, mit Abstand; schraffiert: nicht geprüft</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PairMatrixModel</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: not checked now, its group does not run or it is in none</source>
        <translation>%1: jetzt nicht geprüft, seine Gruppe läuft nicht, oder es ist in keiner</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1, %2, %3 {1:?} {2,?}</translation>
    </message>
    <message>
        <source>%1: never checked, %2</source>
        <translation>%1: nie geprüft, %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PairPanel</name>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Filter pairs by name</source>
        <translation>Paare nach Namen filtern</translation>
    </message>
    <message>
        <source>Class of pairs</source>
        <translation>Klasse der Paare</translation>
    </message>
    <message>
        <source>Whom the listed distances are about</source>
        <translation>Um wen es bei den gezeigten Abständen geht</translation>
    </message>
    <message>
        <source>Only the selection  ✕</source>
        <translation>Nur die Auswahl  ✕</translation>
    </message>
    <message>
        <source>Show all pairs again (Esc)</source>
        <translation>Wieder alle Paare zeigen (Esc)</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>⚠ inside margin</source>
        <translation>⚠ unterschritten</translation>
    </message>
    <message>
        <source>All pairs</source>
        <translation>Alle Paare</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 von %2 Paaren</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PairTableModel</name>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Between the bare surfaces, negative inside</source>
        <translation>Zwischen den bloßen Oberflächen; negativ: Durchdringung</translation>
    </message>
    <message>
        <source>Distance [%1]</source>
        <translation>Abstand [%1]</translation>
    </message>
    <message>
        <source>Uncertainty [%1]</source>
        <translation>Unsicherheit [%1]</translation>
    </message>
    <message>
        <source>Margin [%1]</source>
        <translation>Sicherheitsabstand [%1]</translation>
    </message>
    <message>
        <source>%1 virtual</source>
        <translation>%1 virtuell</translation>
    </message>
    <message>
        <source>Shell points</source>
        <translation>Hüllpunkte</translation>
    </message>
    <message>
        <source>Touching: it is not certain that the surfaces are apart. Inside margin: nothing touches, but it is not certain that the margins are kept. Near: closer than twice the margins. Pose lost: the distance is that of an old pose. Not checked: their group does not run.</source>
        <translation>Berührt: Es ist nicht sicher, dass die Oberflächen getrennt sind. Unterschritten: nichts berührt sich, aber es ist nicht sicher, dass die Sicherheitsabstände eingehalten sind. Nahe: näher als die doppelten Sicherheitsabstände. Pose verloren: Der Abstand ist der einer alten Pose. Nicht geprüft: Ihre Gruppe läuft nicht.</translation>
    </message>
    <message>
        <source>Contact force where the two touch; virtual: of the margins alone, nothing touches</source>
        <translation>Kontaktkraft, wo sich beide berühren; virtuell: nur der Sicherheitsabstände, nichts berührt sich</translation>
    </message>
    <message>
        <source>Points of the one&apos;s shell that are inside the margin of the other, or inside of it</source>
        <translation>Punkte der Hülle des einen, die im Sicherheitsabstand des anderen oder in ihm sind</translation>
    </message>
    <message>
        <source>pose unknown</source>
        <translation>Pose unbekannt</translation>
    </message>
    <message>
        <source>Error bound of the surfaces plus the uncertainty of both poses. The distance minus this is what is compared with the margin</source>
        <translation>Fehlerschranke der Oberflächen und Unsicherheit beider Posen. Der Abstand abzüglich dieses Werts wird mit dem Sicherheitsabstand verglichen</translation>
    </message>
    <message>
        <source>Sum of both objects&apos; safety margins</source>
        <translation>Summe der Sicherheitsabstände beider Objekte</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PathField</name>
    <message>
        <source>Files…</source>
        <translation>Dateien…</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Several paths, with semicolons between them</source>
        <translation>Mehrere Pfade, mit Semikolons dazwischen</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PersonEditor</name>
    <message>
        <source>Rebuild the person</source>
        <translation>Person neu aufbauen</translation>
    </message>
    <message>
        <source>Stature</source>
        <translation>Körpergröße</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Girths, breadths and depths enclose those of this percentage of the people of that stature</source>
        <translation>Umfänge, Breiten und Tiefen umfassen die dieses Anteils der Menschen dieser Größe</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source> kg</source>
        <translation> kg</translation>
    </message>
    <message>
        <source>as in the scene</source>
        <translation>wie in der Szene</translation>
    </message>
    <message>
        <source>female</source>
        <translation>weiblich</translation>
    </message>
    <message>
        <source>male</source>
        <translation>männlich</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>In the background; what is shown stays until the new person is there</source>
        <translation>Im Hintergrund; das Gezeigte bleibt, bis die neue Person da ist</translation>
    </message>
    <message>
        <source>Not ticked: as in the scene</source>
        <translation>Ohne Haken: wie in der Szene</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PictureCommands</name>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Das Bild liegt in der Zwischenablage</translation>
    </message>
    <message>
        <source>Save video</source>
        <translation>Video speichern</translation>
    </message>
    <message>
        <source>Videos (*.avi)</source>
        <translation>Videos (*.avi)</translation>
    </message>
    <message>
        <source>Save plots</source>
        <translation>Diagramme speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;Drawing (*.svg);;Picture (*.png)</source>
        <translation>Tabelle (*.csv);;Zeichnung (*.svg);;Bild (*.png)</translation>
    </message>
    <message>
        <source>Save screenshot</source>
        <translation>Bildschirmfoto speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Screenshot</source>
        <translation>Bildschirmfoto</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PlacementEditor</name>
    <message>
        <source>As in the scene</source>
        <translation>Wie in der Szene</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Place, %1</source>
        <translation>Ort, %1</translation>
    </message>
    <message>
        <source>Turn, %1</source>
        <translation>Drehung, %1</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Ort von %1</translation>
    </message>
    <message>
        <source>Where the origin of the recording is in the world</source>
        <translation>Wo der Ursprung der Aufnahme in der Welt liegt</translation>
    </message>
    <message>
        <source>Where the base of the robot is in the world</source>
        <translation>Wo die Basis des Roboters in der Welt steht</translation>
    </message>
    <message>
        <source>Where the origin of the body is in the world</source>
        <translation>Wo der Ursprung des Körpers in der Welt liegt</translation>
    </message>
</context>
<context>
    <name>abstand::ui::PlotPanel</name>
    <message>
        <source>Smallest distance</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Largest joint torques</source>
        <translation>Größte Gelenkmomente</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>reaction</source>
        <translation>Reaktion</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Torques on the joints: of contact (margins too), what the reaction adds, of gravity, and of the
motion itself (inertia). Gravity and motion are unknown (–) where the robot&apos;s file names no masses.</source>
        <translation>Drehmomente an den Gelenken: des Kontakts (auch der Sicherheitsabstände), was die Reaktion hinzufügt, der Schwerkraft und
der Bewegung selbst (Trägheit). Schwerkraft und Bewegung sind unbekannt (–), wo die Datei des Roboters keine Massen nennt.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>Time span of the plots</source>
        <translation>Zeitspanne der Diagramme</translation>
    </message>
    <message>
        <source>How much time the plots show while they follow</source>
        <translation>Wie viel Zeit die Diagramme zeigen, während sie ihr folgen</translation>
    </message>
    <message>
        <source>&amp;Joint</source>
        <translation>&amp;Gelenk</translation>
    </message>
    <message>
        <source>Joint whose torques are plotted</source>
        <translation>Gelenk, dessen Drehmomente gezeichnet werden</translation>
    </message>
    <message>
        <source>The joint whose torques are plotted, or the largest of all joints</source>
        <translation>Das Gelenk, dessen Drehmomente gezeichnet werden, oder das größte aller Gelenke</translation>
    </message>
    <message>
        <source>largest of all</source>
        <translation>größtes von allen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Forces on %1</source>
        <translation>Kräfte auf %1</translation>
    </message>
    <message>
        <source>Torques on %1</source>
        <translation>Drehmomente auf %1</translation>
    </message>
    <message>
        <source>margin %1</source>
        <translation>Sicherheitsabstand %1</translation>
    </message>
    <message>
        <source>Smallest distance of each class of pairs. Certified: never more than the true distance, over the
whole recording; the others as far as they were played. Drop bodies and pairs here.</source>
        <translation>Kleinster Abstand jeder Klasse von Paaren. Gesichert: nie mehr als der wahre Abstand, über die
ganze Aufnahme; die anderen, soweit abgespielt. Körper und Paare hier ablegen.</translation>
    </message>
    <message>
        <source>Largest force of a pair. Contact: its surfaces touch. Virtual: it is only inside its margin, and
nothing touches. Of earlier margins: played before a margin was changed; play it again.</source>
        <translation>Größte Kraft eines Paares. Kontakt: Seine Oberflächen berühren sich. Virtuell: Es unterschreitet nur den Sicherheitsabstand,
und nichts berührt sich. Früherer Sicherheitsabstände: abgespielt vor einer Änderung; neu abspielen.</translation>
    </message>
    <message>
        <source>Time &amp;span</source>
        <translation>Zeit&amp;spanne</translation>
    </message>
    <message>
        <source>%1, certified</source>
        <translation>%1, gesichert</translation>
    </message>
    <message>
        <source>virtual (margin)</source>
        <translation>virtuell</translation>
    </message>
    <message>
        <source>of earlier margins</source>
        <translation>früherer Sicherheitsabstände</translation>
    </message>
    <message>
        <source>contact and margins</source>
        <translation>Kontakt und Sicherheitsabstände</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ProjectCommands</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The project has changes that are not saved. Save them?</source>
        <translation>Das Projekt hat Änderungen, die nicht gespeichert sind. Sollen sie gespeichert werden?</translation>
    </message>
    <message>
        <source>Cannot open the project</source>
        <translation>Das Projekt kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>%1: names %2, which was not found</source>
        <translation>%1: nennt %2, das nicht gefunden wurde</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Cannot save the project</source>
        <translation>Das Projekt kann nicht gespeichert werden</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ProposalDialog</name>
    <message>
        <source> No stop was ever needed.</source>
        <translation> Ein Stopp war nie nötig.</translation>
    </message>
    <message>
        <source> Decided at &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt; by %3. Of it: error of the distance %4, pose %5, motion in one frame %6.</source>
        <translation> Entschieden bei &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt; durch %3. Davon: Unsicherheit des Abstands %4, Pose %5, Bewegung in einem Einzelbild %6.</translation>
    </message>
    <message>
        <source>Proposed margins</source>
        <translation>Vorgeschlagene Sicherheitsabstände</translation>
    </message>
    <message>
        <source>The smallest margin of each body part without a missed stop in this recording, as &quot;abstand tune&quot; proposes it. It holds for this recording alone and replaces no risk assessment.</source>
        <translation>Der kleinste Sicherheitsabstand jedes Körperteils ohne verpassten Stopp in dieser Aufnahme, wie ihn „abstand tune“ vorschlägt. Er gilt für diese Aufnahme allein und ersetzt keine Risikobeurteilung.</translation>
    </message>
    <message>
        <source>&amp;Apply to unlocked rows</source>
        <translation>Auf nicht gesperrte Zeilen &amp;anwenden</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ReactionPanel</name>
    <message>
        <source>Back to the scene file</source>
        <translation>Zurück zur Szenendatei</translation>
    </message>
    <message>
        <source>Robot whose laws are shown</source>
        <translation>Roboter, dessen Regelgesetze zu sehen sind</translation>
    </message>
    <message>
        <source>All laws and numbers of this robot as in the scene file</source>
        <translation>Alle Regelgesetze und Zahlen dieses Roboters wie in der Szenendatei</translation>
    </message>
    <message>
        <source>Laws and numbers</source>
        <translation>Regelgesetze und Zahlen</translation>
    </message>
    <message>
        <source>back to the scene file</source>
        <translation>zurück zur Szenendatei</translation>
    </message>
    <message>
        <source>No robot of this scene has a reaction.</source>
        <translation>Kein Roboter dieser Szene hat eine Reaktion.</translation>
    </message>
    <message>
        <source>The laws are those of the server.</source>
        <translation>Es gelten die Regelgesetze des Servers.</translation>
    </message>
    <message>
        <source>As in the scene file</source>
        <translation>Wie in der Szenendatei</translation>
    </message>
    <message numerus="yes">
        <source>%n differences from the scene file</source>
        <translation>
            <numerusform>%n Abweichung von der Szenendatei</numerusform>
            <numerusform>%n Abweichungen von der Szenendatei</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 an</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 aus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>What it does for each reason</source>
        <translation>Was er bei welchem Grund tut</translation>
    </message>
    <message>
        <source>Switching it starts the robots anew on their planned motion.</source>
        <translation>Umschalten lässt die Roboter auf ihrer geplanten Bewegung neu beginnen.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::RecordingPanel</name>
    <message>
        <source>%1 (guessed)</source>
        <translation>%1 (geraten)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message numerus="yes">
        <source>%1 s, %n frames</source>
        <translation>
            <numerusform>%1 s, %n Einzelbild</numerusform>
            <numerusform>%1 s, %n Einzelbilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Senkrechte Achse</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Stature</source>
        <translation>Körpergröße</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Joint map</source>
        <translation>Gelenkzuordnung</translation>
    </message>
    <message>
        <source>Moved parts</source>
        <translation>Bewegte Körperteile</translation>
    </message>
    <message>
        <source>nothing moves %1</source>
        <translation>nichts bewegt %1</translation>
    </message>
    <message numerus="yes">
        <source>cut: %n frames at least are missing or not complete</source>
        <translation>
            <numerusform>abgeschnitten: mindestens %n Einzelbild fehlt oder ist unvollständig</numerusform>
            <numerusform>abgeschnitten: mindestens %n Einzelbilder fehlen oder sind unvollständig</numerusform>
        </translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message numerus="yes">
        <source>%n frames lack a joint</source>
        <translation>
            <numerusform>in %n Einzelbild fehlt ein Gelenk</numerusform>
            <numerusform>in %n Einzelbildern fehlt ein Gelenk</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Gelesen als</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Keine Aufnahme</translation>
    </message>
    <message>
        <source>The people of this scene stand still</source>
        <translation>Die Personen dieser Szene stehen still</translation>
    </message>
    <message>
        <source>Shown recording</source>
        <translation>Gezeigte Aufnahme</translation>
    </message>
    <message>
        <source>Of the recordings that were opened together; margins, view and selection stay</source>
        <translation>Von den zusammen geöffneten Aufnahmen; Abstände, Ansicht und Auswahl bleiben</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgenommen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ReportCommands</name>
    <message>
        <source>Making the report…</source>
        <translation>Der Bericht wird erstellt…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>The report was written to
%1</source>
        <translation>Der Bericht wurde geschrieben:
%1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>No report</source>
        <translation>Kein Bericht</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ReportDialog</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Clearance that a moving robot must keep; 0: no contact</source>
        <translation>Abstand, den ein bewegter Roboter einhalten muss; 0: Er darf nicht berühren</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>From the frame that breaks a margin until the robot slows down</source>
        <translation>Vom Einzelbild, das einen Sicherheitsabstand unterschreitet, bis der Roboter langsamer wird</translation>
    </message>
    <message>
        <source> rad/s² or m/s²</source>
        <translation> rad/s² oder m/s²</translation>
    </message>
    <message>
        <source>Of every joint, on the path of its motion</source>
        <translation>Jedes Gelenks, auf der Bahn seiner Bewegung</translation>
    </message>
    <message>
        <source>From the end of an intrusion until the robot resumes</source>
        <translation>Vom Ende einer Unterschreitung, bis der Roboter weiterfährt</translation>
    </message>
    <message>
        <source>A report to read and sign: the outcome of the present margins over the whole recording, the smallest safe margins and permitted speeds, the worst moments with pictures, and the assumptions. It is made by &quot;abstand tune&quot; and can take a minute.</source>
        <translation>Eine Seite zum Lesen und Unterschreiben: was die jetzigen Sicherheitsabstände über die ganze Aufnahme bewirkt hätten, die kleinsten sicheren Sicherheitsabstände und zulässigen Geschwindigkeiten, die schlimmsten Augenblicke mit Bildern, und was angenommen wurde. „abstand tune“ erstellt sie; das kann eine Minute dauern.</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Du&amp;rchsuchen…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Clearance &amp;limit</source>
        <translation>Einzuhaltender &amp;Abstand</translation>
    </message>
    <message>
        <source>&amp;Reaction time</source>
        <translation>Rea&amp;ktionszeit</translation>
    </message>
    <message>
        <source>&amp;Deceleration</source>
        <translation>&amp;Verzögerung</translation>
    </message>
    <message>
        <source>Re&amp;start time</source>
        <translation>&amp;Wiederanlaufzeit</translation>
    </message>
    <message>
        <source>&amp;Make report</source>
        <translation>&amp;Bericht erstellen</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>Datei des Berichts</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF documents (*.pdf)</source>
        <translation>Webseiten (*.html);;PDF-Dokumente (*.pdf)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ResponseRow</name>
    <message>
        <source>Response to: %1</source>
        <translation>Antwort auf: %1</translation>
    </message>
    <message>
        <source>In scene files: stop.on.%1; in this one: %2.</source>
        <translation>In Szenendateien: stop.on.%1; in dieser: %2.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::RobotPanel</name>
    <message>
        <source>Reset protective stops</source>
        <translation>Stopps quittieren</translation>
    </message>
    <message>
        <source>Let every robot that waits for it go on</source>
        <translation>Jeden Roboter weiterfahren lassen, der darauf wartet</translation>
    </message>
    <message>
        <source>No change of state yet</source>
        <translation>Noch keine Zustandsänderung</translation>
    </message>
    <message>
        <source>Changes of state</source>
        <translation>Zustandsänderungen</translation>
    </message>
    <message>
        <source>When a robot slowed down, stopped or went on, and why</source>
        <translation>Wann ein Roboter langsamer wurde, anhielt oder weiterfuhr, und warum</translation>
    </message>
    <message>
        <source>No robot of this scene has a reaction: all follow their recorded motion.</source>
        <translation>Kein Roboter dieser Szene hat eine Reaktion: Alle folgen ihrer aufgenommenen Bewegung.</translation>
    </message>
    <message>
        <source>Not reacting: %1</source>
        <translation>Ohne Reaktion: %1</translation>
    </message>
    <message>
        <source>Restarted on their planned motion at %1; reacting since then</source>
        <translation>Bei %1 neu gestartet; reagieren seitdem</translation>
    </message>
    <message>
        <source>Not reacting: robots follow their recorded motion.</source>
        <translation>Keine Reaktion: Roboter folgen ihrer aufgenommenen Bewegung.</translation>
    </message>
    <message>
        <source>What a robot does depends on what happened before: a seek, a frame back and a new
round put the robots on their plans at that time, and they react from there.</source>
        <translation>Was ein Roboter tut, hängt davon ab, was vorher geschah: Ein Sprung, ein Einzelbild zurück und eine neue
Runde setzen die Roboter auf ihre Pläne zu dieser Zeit, und von dort reagieren sie.</translation>
    </message>
    <message>
        <source>%1%2: %3 since %4, speed %5 %</source>
        <translation>%1%2: %3 seit %4, Geschwindigkeit %5 %</translation>
    </message>
    <message>
        <source>%1: %2 earlier changes are not listed</source>
        <translation>%1: %2 frühere Änderungen sind nicht aufgeführt</translation>
    </message>
    <message>
        <source>%1  %2: reset refused: %3</source>
        <translation>%1  %2: Quittierung abgelehnt: %3</translation>
    </message>
    <message>
        <source>%1: posed by hand</source>
        <translation>%1: von Hand gestellt</translation>
    </message>
    <message>
        <source>Its reaction is suspended until it follows its motion again.</source>
        <translation>Seine Reaktion ruht, bis er wieder seiner Bewegung folgt.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Select the two bodies that hold %1</source>
        <translation>Die beiden Körper auswählen, die %1 aufhalten</translation>
    </message>
    <message>
        <source>As the server reports them; their controllers react.</source>
        <translation>Wie der Server sie meldet; es reagieren ihre Steuerungen.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SceneEdits</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>run pair group %1</source>
        <translation>Gruppe %1 laufen lassen</translation>
    </message>
    <message>
        <source>pause pair group %1</source>
        <translation>Gruppe %1 pausieren</translation>
    </message>
    <message>
        <source>stop pair group %1</source>
        <translation>Gruppe %1 stoppen</translation>
    </message>
    <message>
        <source>remove %1 – %2 from its group</source>
        <translation>%1 – %2 aus der Gruppe nehmen</translation>
    </message>
    <message>
        <source>add %1 – %2 to a group</source>
        <translation>%1 – %2 in eine Gruppe aufnehmen</translation>
    </message>
    <message>
        <source>The group of this pair does not run: see the panel Groups</source>
        <translation>Die Gruppe dieses Paares läuft nicht: siehe das Feld Gruppen</translation>
    </message>
    <message>
        <source>check %1 – %2</source>
        <translation>%1 – %2 prüfen</translation>
    </message>
    <message>
        <source>do not check %1 – %2</source>
        <translation>%1 – %2 nicht prüfen</translation>
    </message>
    <message>
        <source>let %1 follow its motion</source>
        <translation>%1 seiner Bewegung folgen lassen</translation>
    </message>
    <message>
        <source>pose %1 by hand</source>
        <translation>%1 von Hand stellen</translation>
    </message>
    <message>
        <source>The server decides which pairs are checked</source>
        <translation>Der Server entscheidet, welche Paare geprüft werden</translation>
    </message>
    <message>
        <source>laws of %1: %2</source>
        <translation>Regelgesetze von %1: %2</translation>
    </message>
    <message>
        <source>The server decides where everything stands</source>
        <translation>Der Server bestimmt, wo alles steht</translation>
    </message>
    <message>
        <source>place %1</source>
        <translation>Ort von %1</translation>
    </message>
    <message>
        <source>place %1 as in the scene</source>
        <translation>Ort von %1 wie in der Szene</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SceneTreeModel</name>
    <message>
        <source>Mechanism, links: %1</source>
        <translation>Mechanismus, Glieder: %1</translation>
    </message>
    <message>
        <source>Person, body parts: %1</source>
        <translation>Person, Körperteile: %1</translation>
    </message>
    <message>
        <source>In the room: %1</source>
        <translation>Im Raum: %1</translation>
    </message>
    <message>
        <source>The pose is stale or was rejected: drawn hollow, never safe</source>
        <translation>Die Pose ist veraltet oder wurde verworfen: hohl gezeichnet, nie sicher</translation>
    </message>
    <message>
        <source>pose lost</source>
        <translation>Pose verloren</translation>
    </message>
    <message>
        <source>Of a robot or a thing: to the nearest person. Of a person: to the nearest object.</source>
        <translation>Eines Roboters oder Gegenstands: zur nächsten Person. Einer Person: zu dem, was am nächsten ist.</translation>
    </message>
    <message>
        <source>To the nearest object</source>
        <translation>Zu dem, was am nächsten ist</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nächster</translation>
    </message>
    <message>
        <source>Touching: %1, inside margins: %2</source>
        <translation>Berührt: %1, unterschritten: %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SceneTreePanel</name>
    <message>
        <source>Scene tree</source>
        <translation>Szenenbaum</translation>
    </message>
    <message>
        <source>⚠ inside margin</source>
        <translation>⚠ unterschritten</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SensorEditor</name>
    <message>
        <source>&amp;Sensor</source>
        <translation>&amp;Sensor</translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation>&amp;x</translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation>&amp;y</translation>
    </message>
    <message>
        <source>&amp;z</source>
        <translation>&amp;z</translation>
    </message>
    <message>
        <source>&amp;Azimuth</source>
        <translation>&amp;Azimut</translation>
    </message>
    <message>
        <source>&amp;Elevation</source>
        <translation>&amp;Neigung</translation>
    </message>
    <message>
        <source>&amp;Roll</source>
        <translation>&amp;Rollen</translation>
    </message>
    <message>
        <source>Place of the sensor in the world</source>
        <translation>Ort des Sensors in der Welt</translation>
    </message>
    <message>
        <source>Direction in which it looks, about the vertical; 0: along x</source>
        <translation>Blickrichtung, um die Senkrechte; 0: entlang x</translation>
    </message>
    <message>
        <source>Direction in which it looks, above the horizon; below 0: down</source>
        <translation>Blickrichtung, über dem Horizont; unter 0: nach unten</translation>
    </message>
    <message>
        <source>Turn about that direction; 0: level</source>
        <translation>Drehung um die Blickrichtung; 0: waagerecht</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SeparationChart</name>
    <message>
        <source>Protective distance of each body part</source>
        <translation>Schutzabstand jedes Körperteils</translation>
    </message>
    <message>
        <source>Body parts have rows here where a scene has a person and a robot</source>
        <translation>Hier stehen Körperteile, wenn eine Szene eine Person und einen Roboter hat</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>reaction</source>
        <translation>Reaktion</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>C + Z</source>
        <translation>C und Z</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>gesicherter Abstand</translation>
    </message>
    <message>
        <source>contact now</source>
        <translation>Kontakt jetzt</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SeparationPanel</name>
    <message>
        <source>The part is clamped</source>
        <translation>Körperteil ist geklemmt</translation>
    </message>
    <message>
        <source>Reaction</source>
        <translation>Reaktion</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>as above</source>
        <translation>wie oben</translation>
    </message>
    <message>
        <source>Deceleration along the approach; with it, the stopping time is speed by deceleration</source>
        <translation>Verzögerung in Richtung der Annäherung; mit ihr ist die Anhaltezeit Geschwindigkeit durch Verzögerung</translation>
    </message>
    <message>
        <source>or decelerates</source>
        <translation>oder bremst mit</translation>
    </message>
    <message>
        <source>Intrusion C</source>
        <translation>Eindringen C</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Person Z_d</source>
        <translation>Z_d der Person</translation>
    </message>
    <message>
        <source>Robot Z_r</source>
        <translation>Z_r des Roboters</translation>
    </message>
    <message>
        <source> kg</source>
        <translation> kg</translation>
    </message>
    <message>
        <source>immovable</source>
        <translation>unbeweglich</translation>
    </message>
    <message>
        <source>Effective mass of the robot in a contact; where it is not known, it counts as immovable</source>
        <translation>Wirksame Masse des Roboters in einem Kontakt; ist sie nicht bekannt, gilt er als unbeweglich</translation>
    </message>
    <message>
        <source>Robot mass</source>
        <translation>Robotermasse</translation>
    </message>
    <message>
        <source>A part that cannot recoil has the lower limit of a quasi-static contact</source>
        <translation>Für ein Körperteil, das nicht ausweichen kann, gilt der niedrigere Grenzwert des quasistatischen Kontakts</translation>
    </message>
    <message>
        <source>No table of contact limits</source>
        <translation>Keine Tabelle der Kontaktgrenzwerte</translation>
    </message>
    <message>
        <source>What separation is judged with</source>
        <translation>Womit der Schutzabstand beurteilt wird</translation>
    </message>
</context>
<context>
    <name>abstand::ui::SpeedDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>limits of a contact</source>
        <translation>Grenzwerte einer Berührung</translation>
    </message>
    <message>
        <source>protective distance</source>
        <translation>Schutzabstand</translation>
    </message>
    <message>
        <source>%1: %2 at %3</source>
        <translation>%1: %2 bei %3</translation>
    </message>
    <message>
        <source>The program takes %1 instead of %2.</source>
        <translation>Das Programm dauert %1 statt %2.</translation>
    </message>
    <message>
        <source>The robot would have to stand where the speed is 0 %: there is no program.</source>
        <translation>Der Roboter müsste stehen, wo die Geschwindigkeit 0 % ist: Es gibt kein Programm.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>No motion was saved: %1</source>
        <translation>Es wurde keine Bewegung gespeichert: %1</translation>
    </message>
    <message>
        <source>Proposed speeds</source>
        <translation>Vorgeschlagene Geschwindigkeiten</translation>
    </message>
    <message>
        <source>The highest share of its speed in each segment of the robots&apos; program at which no recorded person would have broken a limit, as &quot;abstand tune&quot; computes it. It holds for this recording alone and replaces no risk assessment.</source>
        <translation>Der höchste Anteil der Geschwindigkeit in jedem Abschnitt des Programms der Roboter, bei dem keine aufgenommene Person eine Grenze verletzt hätte, wie „abstand tune“ ihn berechnet. Er gilt nur für diese Aufnahme und ersetzt keine Risikobeurteilung.</translation>
    </message>
    <message>
        <source>Protective distance and contact limits</source>
        <translation>Schutzabstand und Grenzwerte von Berührungen</translation>
    </message>
    <message>
        <source>Protective distance alone</source>
        <translation>Nur Schutzabstand</translation>
    </message>
    <message>
        <source>Contact limits alone</source>
        <translation>Nur Grenzwerte von Berührungen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Rule</source>
        <translation>&amp;Regel</translation>
    </message>
    <message>
        <source>&amp;Length of a segment</source>
        <translation>&amp;Länge eines Abschnitts</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Begrenzt durch</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Durch Abstand</translation>
    </message>
    <message>
        <source>By contact</source>
        <translation>Durch Berührung</translation>
    </message>
    <message>
        <source>Permitted speeds</source>
        <translation>Zulässige Geschwindigkeiten</translation>
    </message>
    <message>
        <source>The speeds are being computed</source>
        <translation>Die Geschwindigkeiten werden berechnet</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Berechnen</translation>
    </message>
    <message>
        <source>&amp;Save motion…</source>
        <translation>Bewegung &amp;speichern…</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Replays the slower program beside the recording until no limit is broken, and saves it as motion files</source>
        <translation>Spielt das langsamere Programm neben der Aufnahme ab, bis keine Grenze verletzt ist, und speichert es als Bewegungsdateien</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Computing distances and speeds…</source>
        <translation>Abstände und Geschwindigkeiten werden berechnet…</translation>
    </message>
    <message>
        <source>Replaying the slower program…</source>
        <translation>Das langsamere Programm wird abgespielt…</translation>
    </message>
    <message>
        <source>Folder for the motions</source>
        <translation>Ordner für die Bewegungen</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>How near do people come to robots?</source>
        <translation>Wie nah kommen Menschen Robotern?</translation>
    </message>
    <message>
        <source>Open a project, a scene, a robot or a recording, or drop it on this window.</source>
        <translation>Ein Projekt, eine Szene, einen Roboter oder eine Aufnahme öffnen oder auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Open the demonstration</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>A recorded boxer before a robot with two arms: %1</source>
        <translation>Ein aufgenommener Boxer vor einem Roboter mit zwei Armen: %1</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
</context>
<context>
    <name>abstand::ui::StatusPanel</name>
    <message>
        <source>Checked %1 of %2</source>
        <translation>%1 von %2 geprüft</translation>
    </message>
    <message>
        <source>, skipped %1 (far away)</source>
        <translation>, %1 übersprungen (weit entfernt)</translation>
    </message>
    <message>
        <source>, postponed %1</source>
        <translation>, %1 verschoben</translation>
    </message>
    <message>
        <source>Pairs in the last cycle
checked: %1
skipped, as they cannot have used up their clearance: %2
skipped, as they are beyond the horizon: %3
postponed, as the time budget was used up: %4 (longest: %5 cycles)
unchanged since the last check: %6
Whatever is skipped, the true distance is never below distance − bound.</source>
        <translation>Paare im letzten Zyklus
geprüft: %1
übersprungen, da sie ihren gesicherten Abstand nicht aufgebraucht haben können: %2
übersprungen, da sie jenseits des Horizonts sind: %3
verschoben, da das Zeitbudget verbraucht war: %4 (am längsten: %5 Zyklen)
unverändert seit der letzten Prüfung: %6
Was auch immer übersprungen wird, der wahre Abstand ist nie kleiner als Abstand − Unsicherheit.</translation>
    </message>
    <message>
        <source>Analysis tool, not a safety function</source>
        <translation>Nur Analyse, keine Sicherheitsfunktion</translation>
    </message>
    <message>
        <source>Nearest pair</source>
        <translation>Nächstes Paar</translation>
    </message>
    <message>
        <source>Time of one computation cycle: median and 99th percentile</source>
        <translation>Zeit eines Rechenzyklus: Median und 99. Perzentil</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>Fortschritt des Öffnens</translation>
    </message>
    <message>
        <source>Progress of the analysis</source>
        <translation>Fortschritt der Auswertung</translation>
    </message>
    <message>
        <source>State of the robots that react</source>
        <translation>Zustand der Roboter mit Reaktion</translation>
    </message>
    <message>
        <source>Pairs that were checked</source>
        <translation>Geprüfte Paare</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop opening, and keep what is there</source>
        <translation>Das Öffnen abbrechen und behalten, was da ist</translation>
    </message>
    <message>
        <source>Checked %1 of %1</source>
        <translation>%1 von %1 geprüft</translation>
    </message>
    <message>
        <source>⚠ %1 pairs not checked. %2</source>
        <translation>⚠ %1 Paare nicht geprüft. %2</translation>
    </message>
    <message>
        <source>Cycle %1 / %2 µs</source>
        <translation>Zyklus %1 / %2 µs</translation>
    </message>
    <message>
        <source>Overruns %1 of %2</source>
        <translation>Überläufe %1 von %2</translation>
    </message>
    <message>
        <source>Cycles that took longer than the step that the loop has chosen, %1 ms, of all
since playing began or its speed changed</source>
        <translation>Zyklen, die länger dauerten als der von der Schleife gewählte Schritt, %1 ms, von allen
seit Beginn der Wiedergabe oder seit ihre Geschwindigkeit sich änderte</translation>
    </message>
    <message>
        <source>Real time –</source>
        <translation>Echtzeit –</translation>
    </message>
    <message>
        <source>Real time %1×</source>
        <translation>Echtzeit %1×</translation>
    </message>
    <message>
        <source>React: off</source>
        <translation>Reagieren: aus</translation>
    </message>
    <message>
        <source>Robots follow their recorded motion (React is off)</source>
        <translation>Roboter folgen ihrer aufgenommenen Bewegung (Reagieren ist aus)</translation>
    </message>
    <message>
        <source>Robots were restarted on their planned motion at %1 and react since then; a seek,
a frame back and a new round restart them. Reasons and times are in the panel
&quot;Robots&quot;.</source>
        <translation>Roboter wurden bei %1 auf ihrer geplanten Bewegung neu gestartet und reagieren seitdem; ein Sprung,
ein Einzelbild zurück und eine neue Runde starten sie neu. Gründe und Zeiten stehen im Bereich
„Roboter“.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Finding the person: image %1 of %2</source>
        <translation>Die Person wird gesucht: Bild %1 von %2</translation>
    </message>
    <message>
        <source>Reading files</source>
        <translation>Dateien werden gelesen</translation>
    </message>
    <message>
        <source>Building structure %1: %2</source>
        <translation>Struktur %1 wird erstellt: %2</translation>
    </message>
    <message>
        <source>Structure %1: %2</source>
        <translation>Struktur %1: %2</translation>
    </message>
    <message>
        <source>Distances of the whole recording are computed for the timeline and the events</source>
        <translation>Die Abstände der ganzen Aufnahme werden für Zeitleiste und Ereignisse berechnet</translation>
    </message>
    <message>
        <source>Scene time that was played by wall time, over the last one and a half seconds.
Moments that were computed and came too fast to be drawn: %1</source>
        <translation>Abgespielte Szenenzeit je Wanduhrzeit, über die letzten anderthalb Sekunden.
Momente, die berechnet wurden und zu schnell kamen, um gezeichnet zu werden: %1</translation>
    </message>
    <message>
        <source>Connection with the server</source>
        <translation>Verbindung mit dem Server</translation>
    </message>
    <message>
        <source>As the server reports it. Reasons and times are in the panel &quot;Robots&quot;.</source>
        <translation>Wie der Server ihn meldet. Gründe und Zeiten stehen im Bereich „Roboter“.</translation>
    </message>
</context>
<context>
    <name>abstand::ui::StripChart</name>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Drag to move the time, wheel to zoom, right button to move the window</source>
        <translation>Ziehen verschiebt die Zeit, das Mausrad zoomt, die rechte Taste verschiebt das Fenster</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>%1: %2 [%3]</source>
        <translation>%1: %2 [%3]</translation>
    </message>
</context>
<context>
    <name>abstand::ui::ThingDrag</name>
    <message>
        <source>move %1</source>
        <translation>%1 bewegen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::TimeCommands</name>
    <message>
        <source>Paused at an event, %1</source>
        <translation>Bei einem Ereignis angehalten, %1</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Wiedergeben</translation>
    </message>
    <message>
        <source>set IN</source>
        <translation>IN setzen</translation>
    </message>
    <message>
        <source>set OUT</source>
        <translation>OUT setzen</translation>
    </message>
    <message>
        <source>clear IN and OUT</source>
        <translation>IN und OUT löschen</translation>
    </message>
    <message>
        <source>No later event known</source>
        <translation>Kein späteres Ereignis bekannt</translation>
    </message>
    <message>
        <source>No earlier event known</source>
        <translation>Kein früheres Ereignis bekannt</translation>
    </message>
    <message>
        <source>No later event known of this kind: %1</source>
        <translation>Kein späteres Ereignis dieser Art bekannt: %1</translation>
    </message>
    <message>
        <source>No earlier event known of this kind: %1</source>
        <translation>Kein früheres Ereignis dieser Art bekannt: %1</translation>
    </message>
</context>
<context>
    <name>abstand::ui::TimeMinimap</name>
    <message>
        <source>Whole recording</source>
        <translation>Ganze Aufnahme</translation>
    </message>
    <message>
        <source>The whole recording. Drag the frame to move what the lanes show (Alt+PgUp, Alt+PgDown), an end of it to show more or less</source>
        <translation>Die ganze Aufnahme. Den Rahmen ziehen verschiebt den Ausschnitt der Spuren (Alt+Bild auf, Alt+Bild ab), ein Ende davon ändert seine Länge</translation>
    </message>
</context>
<context>
    <name>abstand::ui::TimeStrip</name>
    <message>
        <source>Time slider with the smallest distance</source>
        <translation>Zeitschieber mit dem kleinsten Abstand</translation>
    </message>
    <message>
        <source>Move it with the arrow keys, Home and End</source>
        <translation>Mit den Pfeiltasten, Pos1 und Ende bewegen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1: not computed yet</source>
        <translation>%1: noch nicht berechnet</translation>
    </message>
    <message>
        <source>%1: smallest distance %2</source>
        <translation>%1: kleinster Abstand %2</translation>
    </message>
    <message>
        <source>; touching</source>
        <translation>; Berührung</translation>
    </message>
    <message>
        <source>; inside a margin</source>
        <translation>; unterschritten</translation>
    </message>
    <message>
        <source>; inside a margin that has changed since: play it again</source>
        <translation>; unterschritten, mit einem Sicherheitsabstand, der sich seither geändert hat: neu abspielen</translation>
    </message>
</context>
<context>
    <name>abstand::ui::TimelinePanel</name>
    <message>
        <source>Body parts have lanes here where a scene has a person and a robot</source>
        <translation>Körperteile haben hier Spuren, wo eine Szene eine Person und einen Roboter hat</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Wiedergabegeschwindigkeit</translation>
    </message>
    <message>
        <source>Speed, 0.05 to 8 times that of the recording (+ and −)</source>
        <translation>Geschwindigkeit, 0,05- bis 8-mal die der Aufnahme (+ und −)</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Go to time or frame</source>
        <translation>Zu Zeit oder Einzelbild gehen</translation>
    </message>
    <message>
        <source>Go to a time or a frame: 12.5, 1:02.5 or f120 (Ctrl+G)</source>
        <translation>Zu einer Zeit oder einem Einzelbild gehen: 12,5, 1:02,5 oder f120 (Strg+G)</translation>
    </message>
    <message>
        <source>Outcome of the present margins</source>
        <translation>Was die jetzigen Sicherheitsabstände bewirkt hätten</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Einzelbild</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>Bild %1 / %2</translation>
    </message>
</context>
<context>
    <name>abstand::ui::Tour</name>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
</context>
<context>
    <name>abstand::ui::VerificationDialog</name>
    <message>
        <source>Verification of the engine</source>
        <translation>Verifikation des Rechenkerns</translation>
    </message>
    <message>
        <source>Checks on this machine, as &quot;abstand verify&quot; makes them: distances against brute force, forces against closed forms, the same bits on any number of threads. A check passes if none of its poses exceeds the limit. The tip of a row says what is tested and why the limit is what it is.</source>
        <translation>Prüfungen auf diesem Rechner wie mit „abstand verify“: Abstände gegen vollständige Suche, Kräfte gegen geschlossene Formeln, gleiche Bits mit jeder Zahl von Threads. Eine Prüfung ist bestanden, wenn keine ihrer Posen die Grenze überschreitet. Der Hinweis einer Zeile nennt, was geprüft wird und warum die Grenze so ist.</translation>
    </message>
    <message>
        <source>Quick: 3,000 poses, about a minute</source>
        <translation>Kurz: 3.000 Posen, etwa eine Minute</translation>
    </message>
    <message>
        <source>Complete: 100,000 poses, some minutes</source>
        <translation>Vollständig: 100.000 Posen, einige Minuten</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>C&amp;hecks</source>
        <translation>&amp;Prüfungen</translation>
    </message>
    <message>
        <source>&amp;Extent</source>
        <translation>&amp;Umfang</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Checks of the engine</source>
        <translation>Prüfungen des Rechenkerns</translation>
    </message>
    <message>
        <source>Progress of the checks</source>
        <translation>Fortschritt der Prüfungen</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Save &amp;page…</source>
        <translation>Seite spei&amp;chern…</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Saves the results with tables and plots as an HTML page</source>
        <translation>Speichert die Ergebnisse mit Tabellen und Diagrammen als HTML-Seite</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Save the page</source>
        <translation>Seite speichern</translation>
    </message>
    <message>
        <source>HTML pages (*.html)</source>
        <translation>HTML-Seiten (*.html)</translation>
    </message>
    <message>
        <source>Stopped: the checks are incomplete.</source>
        <translation>Angehalten: Die Prüfungen sind unvollständig.</translation>
    </message>
    <message>
        <source>%1
Numbers: %2
Limit: %3</source>
        <translation>%1
Zahlen: %2
Grenze: %3</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message numerus="yes">
        <source>⚠ %n breaches</source>
        <translation>
            <numerusform>⚠ %n Verletzung</numerusform>
            <numerusform>⚠ %n Verletzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Checking: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
    <message numerus="yes">
        <source>Passed: all %n checks.</source>
        <translation>
            <numerusform>Bestanden: %n Prüfung.</numerusform>
            <numerusform>Bestanden: alle %n Prüfungen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not passed: %1 of %n checks.</source>
        <translation>
            <numerusform>Nicht bestanden: %1 von %n Prüfung.</numerusform>
            <numerusform>Nicht bestanden: %1 von %n Prüfungen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>abstand::ui::VideoRecorder</name>
    <message>
        <source>No video</source>
        <translation>Kein Video</translation>
    </message>
    <message>
        <source>Making the video…</source>
        <translation>Das Video wird erstellt…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
</context>
<context>
    <name>abstand::ui::Viewport</name>
    <message>
        <source>No OpenGL 3.2 here: the 3D view stays empty, everything else works.</source>
        <translation>Hier gibt es kein OpenGL 3.2: Die 3D-Ansicht bleibt leer, alles andere funktioniert.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Contact force: %1 ≙ %2 N</source>
        <translation>Kontaktkraft: %1 ≙ %2 N</translation>
    </message>
    <message>
        <source>Torque: %1 ≙ %2 N·m</source>
        <translation>Drehmoment: %1 ≙ %2 N·m</translation>
    </message>
    <message>
        <source>Velocity: %1 ≙ %2 m/s</source>
        <translation>Geschwindigkeit: %1 ≙ %2 m/s</translation>
    </message>
    <message>
        <source>⚠ %1, %2</source>
        <translation>⚠ %1, %2</translation>
    </message>
    <message>
        <source>▲ %1, %2</source>
        <translation>▲ %1, %2</translation>
    </message>
    <message>
        <source>%1 is posed by hand</source>
        <translation>%1 ist von Hand gestellt</translation>
    </message>
    <message>
        <source> (reset: %1)</source>
        <translation> (quittieren: %1)</translation>
    </message>
    <message>
        <source>Poke: %1 N</source>
        <translation>Stoß: %1 N</translation>
    </message>
    <message>
        <source>⚠ %1: %2</source>
        <translation>⚠ %1: %2</translation>
    </message>
    <message>
        <source>Virtual (margin) force: %1 ≙ %2 N</source>
        <translation>Virtuelle Kraft (Sicherheitsabstand): %1 ≙ %2 N</translation>
    </message>
    <message>
        <source>Joint torque of contacts and margins: %1 ≙ %2 N·m</source>
        <translation>Gelenkmoment von Kontakten und Sicherheitsabständen: %1 ≙ %2 N·m</translation>
    </message>
    <message>
        <source>Joint force of contacts and margins: %1 ≙ %2 N</source>
        <translation>Gelenkkraft von Kontakten und Sicherheitsabständen: %1 ≙ %2 N</translation>
    </message>
    <message>
        <source>Depth: person</source>
        <translation>Tiefe: Person</translation>
    </message>
    <message>
        <source>Depth: robot</source>
        <translation>Tiefe: Roboter</translation>
    </message>
    <message>
        <source>Depth: other</source>
        <translation>Tiefe: anderes</translation>
    </message>
    <message>
        <source>Depth: joint tracked</source>
        <translation>Tiefe: Gelenk verfolgt</translation>
    </message>
    <message>
        <source>Depth: joint inferred</source>
        <translation>Tiefe: Gelenk erschlossen</translation>
    </message>
    <message>
        <source>Depth: joint unknown</source>
        <translation>Tiefe: Gelenk unbekannt</translation>
    </message>
</context>
<context>
    <name>abstand::ui::WatchedSeries</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>connect_dialog</name>
    <message>
        <source>Connect to a running serve</source>
        <translation>Mit laufendem serve verbinden</translation>
    </message>
    <message>
        <source>Address and port of abstand serve, as it prints them</source>
        <translation>Adresse und Port von abstand serve, wie es sie ausgibt</translation>
    </message>
    <message>
        <source>the file that the server states</source>
        <translation>die Datei, die der Server nennt</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>The window only looks on: nothing here changes what the server does.</source>
        <translation>Das Fenster sieht nur zu: Nichts hier ändert, was der Server tut.</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>&amp;Scene</source>
        <translation>&amp;Szene</translation>
    </message>
</context>
<context>
    <name>file_kinds</name>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>Projekte</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Projects, scenes, robots, meshes and recordings</source>
        <translation>Projekte, Szenen, Roboter, Netze und Aufnahmen</translation>
    </message>
</context>
<context>
    <name>format</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>Orbit; a click selects</source>
        <translation>Drehen; ein Klick wählt aus</translation>
    </message>
    <message>
        <source>Right or middle button, or Shift and left button</source>
        <translation>Rechte oder mittlere Taste, oder Umschalt und linke Taste</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Zoom to the selection</source>
        <translation>Auf die Auswahl zoomen</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>Open a project, a scene, a robot or a recording</source>
        <translation>Ein Projekt, eine Szene, einen Roboter oder eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Maus in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>About Abstand</source>
        <translation>Über Abstand</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Abstand %1&lt;/h3&gt;&lt;p&gt;Distances and contact between people and robots: how close did they come, how hard would they have touched, and which safety margin would have been right.&lt;/p&gt;&lt;p&gt;&lt;b&gt;This is an analysis tool, not a safety function.&lt;/b&gt; Do not use it to stop a machine or to protect a person.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Abstand %1&lt;/h3&gt;&lt;p&gt;Abstände und Kontakt zwischen Personen und Robotern: Wie nahe kamen sie sich, wie stark hätten sie sich berührt, und welcher Sicherheitsabstand wäre richtig gewesen.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Dies ist ein Analysewerkzeug, keine Sicherheitsfunktion.&lt;/b&gt; Verwenden Sie es nicht, um eine Maschine anzuhalten oder eine Person zu schützen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Ctrl and left button</source>
        <translation>Strg und linke Taste</translation>
    </message>
    <message>
        <source>Pull a link of a robot</source>
        <translation>Ein Glied eines Roboters ziehen</translation>
    </message>
    <message>
        <source>Ctrl, Shift and left button</source>
        <translation>Strg, Umschalt und linke Taste</translation>
    </message>
    <message>
        <source>Poke a robot that reacts: 4 N per cm, at most 150 N</source>
        <translation>Einen reagierenden Roboter stoßen: 4 N je cm, höchstens 150 N</translation>
    </message>
    <message>
        <source>Left button on an arrow or the ring of a selected thing</source>
        <translation>Linke Taste auf Pfeil oder Ring eines ausgewählten Gegenstands</translation>
    </message>
    <message>
        <source>Move or turn it</source>
        <translation>Ihn bewegen oder drehen</translation>
    </message>
    <message>
        <source>Alt and left button</source>
        <translation>Alt und linke Taste</translation>
    </message>
    <message>
        <source>Scrub: the width of the view is what the timeline shows</source>
        <translation>In der Zeit fahren: Die Breite der Ansicht entspricht dem Ausschnitt der Zeitleiste</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Shows how close people come to robots. An analysis tool, not a safety function.
Example: abstand-studio data/scenes/hug_boxing.yaml --at 5</source>
        <translation>Zeigt, wie nahe Personen Robotern kommen. Ein Analysewerkzeug, keine Sicherheitsfunktion.
Beispiel: abstand-studio data/scenes/hug_boxing.yaml --at 5</translation>
    </message>
    <message>
        <source>recording that replaces those of the scene</source>
        <translation>Aufnahme, die die der Szene ersetzt</translation>
    </message>
    <message>
        <source>folder that holds ROS packages; may be given several times</source>
        <translation>Ordner mit ROS-Paketen; mehrfach möglich</translation>
    </message>
    <message>
        <source>start at this time</source>
        <translation>bei dieser Zeit beginnen</translation>
    </message>
    <message>
        <source>off: robots follow their planned motion regardless of people</source>
        <translation>off: Roboter folgen ihrer Bewegung, wer auch da ist</translation>
    </message>
    <message>
        <source>save a picture of the window and end</source>
        <translation>ein Bild des Fensters speichern und enden</translation>
    </message>
    <message>
        <source>size of the window</source>
        <translation>Größe des Fensters</translation>
    </message>
    <message>
        <source>play this long first</source>
        <translation>erst so lange wiedergeben</translation>
    </message>
    <message>
        <source>play this long, print frame rate, stalls and processor time as JSON, and end</source>
        <translation>so lange wiedergeben, Bildrate, Aussetzer und Rechenzeit als JSON ausgeben und enden</translation>
    </message>
    <message>
        <source>language of texts and numbers</source>
        <translation>Sprache der Texte und Zahlen</translation>
    </message>
    <message>
        <source>show what a running abstand serve computes at this address</source>
        <translation>zeigen, was ein laufendes abstand serve unter dieser Adresse berechnet</translation>
    </message>
    <message>
        <source>projects, scenes, robots, meshes and recordings; several are shown together</source>
        <translation>Projekte, Szenen, Roboter, Netze und Aufnahmen; mehrere werden zusammen gezeigt</translation>
    </message>
    <message>
        <source>work this long on the scene, print memory over time as JSON, and end</source>
        <translation>so lange mit der Szene arbeiten, den Speicherbedarf über der Zeit als JSON ausgeben, dann enden</translation>
    </message>
</context>
<context>
    <name>missing_files</name>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Missing file</source>
        <translation>Fehlende Datei</translation>
    </message>
    <message>
        <source>&amp;Locate…</source>
        <translation>&amp;Suchen…</translation>
    </message>
    <message>
        <source>&amp;Use the scene&apos;s recording</source>
        <translation>Die Aufnahme der Szene &amp;verwenden</translation>
    </message>
    <message>
        <source>The scene of the project was not found:
%1</source>
        <translation>Die Szene des Projekts wurde nicht gefunden:
%1</translation>
    </message>
    <message>
        <source>The recording of the project was not found:
%1</source>
        <translation>Die Aufnahme des Projekts wurde nicht gefunden:
%1</translation>
    </message>
    <message>
        <source>A file that the project adds was not found:
%1</source>
        <translation>Eine Datei, die das Projekt hinzufügt, wurde nicht gefunden:
%1</translation>
    </message>
    <message>
        <source>&amp;Do without it</source>
        <translation>&amp;Ohne sie weiter</translation>
    </message>
</context>
<context>
    <name>reading_dialog</name>
    <message>
        <source>as in the scene</source>
        <translation>wie die Szene sagt</translation>
    </message>
    <message>
        <source>guessed from the file</source>
        <translation>aus der Datei geraten</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>Aufnahmeoptionen</translation>
    </message>
    <message>
        <source>2: people move twice as fast as recorded</source>
        <translation>2: Personen bewegen sich doppelt so schnell wie aufgenommen</translation>
    </message>
    <message>
        <source>Cut the scene&apos;s robots and objects out of depth images</source>
        <translation>Roboter und Gegenstände der Szene aus Tiefenbildern ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Units of the file</source>
        <translation>&amp;Einheiten der Datei</translation>
    </message>
    <message>
        <source>Axis that points &amp;up</source>
        <translation>Achse nach &amp;oben</translation>
    </message>
    <message>
        <source>&amp;Speed of people</source>
        <translation>&amp;Geschwindigkeit der Personen</translation>
    </message>
</context>
<context>
    <name>recovery</name>
    <message>
        <source>The program did not end properly, and its work of %1 cannot be read:
%2</source>
        <translation>Das Programm wurde nicht ordentlich beendet, und seine Arbeit von %1 kann nicht gelesen werden:
%2</translation>
    </message>
    <message>
        <source>The program did not end properly. Its work on %1 was kept at %2. Recover it?</source>
        <translation>Das Programm wurde nicht ordentlich beendet. Seine Arbeit an %1 wurde am %2 gesichert. Soll sie wiederhergestellt werden?</translation>
    </message>
    <message>
        <source>Recover work</source>
        <translation>Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
</context>
</TS>
